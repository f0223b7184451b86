"""Text: a prompt becomes tokens, with whole quantities as one token each."""
