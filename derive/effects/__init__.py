"""Effects that move a mechanism beside gravity and contact: drives, forces, springs, dampers, friction of joints."""
