"""What became of the words of a prompt in the draft of a language model."""
