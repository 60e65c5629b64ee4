"""Kinematics of trees, closed loops, equations of motion."""
