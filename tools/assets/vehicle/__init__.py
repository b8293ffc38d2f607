"""Vehicles by script: see README.md."""
