"""Structural analysis: sheets that are held and loaded, followed through snap-through, and gradients of their states."""

from ._native import Configuration, Structure

__all__ = ["Configuration", "Structure"]


def _again(model, job, numbers):
    """A structure that was pickled."""
    return Structure(model, job).replace(**numbers)
