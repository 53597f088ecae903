#!/usr/bin/env python3
"""plant.py FILE FROM TO: replaces FROM, which has to be there, once: a fault in a copy, for a check to find."""
import sys

path, old, new = sys.argv[1:]
with open(path, encoding="utf-8") as file:
    text = file.read()
if old not in text:
    sys.exit(f"{path}: nothing says {old!r}")
with open(path, "w", encoding="utf-8") as file:
    file.write(text.replace(old, new, 1))
