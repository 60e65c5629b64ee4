"""Inputs of a run as a user gives them: arrays, tables, functions, constants, columns of files; read into signals."""
