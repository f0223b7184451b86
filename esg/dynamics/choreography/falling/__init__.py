"""What is dropped, falls off something or is thrown: where it starts and when it lands."""
