"""The Python interface: what `import esg` offers (docs/api.md), under the command line."""
