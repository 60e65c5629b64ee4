"""Where surfaces touch, and the forces there."""
