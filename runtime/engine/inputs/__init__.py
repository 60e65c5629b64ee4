"""Inputs of a run as a user gives them: arrays, tables, functions, files; read into signals."""
