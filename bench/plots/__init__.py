"""The pictures that bench/plot.py draws."""
