"""Assets from outside: importers, generators, the libraries kept on this machine."""
