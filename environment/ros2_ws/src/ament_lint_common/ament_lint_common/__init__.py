"""What the linters share."""
