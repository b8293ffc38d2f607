"""Surfaces of all worlds, made from noise."""
