"""Measures that need no fold."""

from ._native import align, flat_folding

__all__ = ["align", "flat_folding"]
