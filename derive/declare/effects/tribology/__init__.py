"""Friction of joints, belts and patches, resistance to rolling, lubrication."""
