"""What a generated module holds: its functions and tables, concept by concept."""
