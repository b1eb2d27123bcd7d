"""How one pixel was subdivided."""

from __future__ import annotations

from dataclasses import dataclass, field


@dataclass
class Sample:
    """A point sample of a cell. Places run from 0 to 1 across the pixel, y down."""

    x: float
    y: float
    weight: float  #: area, as a fraction of the pixel
    radiance: tuple[float, float, float]  #: linear


@dataclass
class Edge:
    """A piece of an edge that passes through a cell."""

    from_x: float
    from_y: float
    to_x: float
    to_y: float


@dataclass
class Cell:
    """A square of the pixel's subdivision; `x`, `y` is its upper left corner."""

    level: int
    x: float
    y: float
    side: float
    fate: str  #: "uniform", "cut", "uneven", "split", "stopped", "finest", "sampled", ...
    edges: list[Edge] = field(default_factory=list)
    samples: list[Sample] = field(default_factory=list)


@dataclass
class PixelTrace:
    """The subdivision of one pixel; `radiance` has the bits of the whole picture."""

    radiance: tuple[float, float, float]
    level: int
    cause: str
    unresolved_area: float  #: fraction of the pixel that stayed marginal
    cells: list[Cell] = field(default_factory=list)


def trace_from(record: dict) -> PixelTrace:
    """Return the trace of a record of the compiled module."""
    cells = [
        Cell(
            **{
                **cell,
                "edges": [Edge(**edge) for edge in cell["edges"]],
                "samples": [
                    Sample(**{**sample, "radiance": tuple(sample["radiance"])})
                    for sample in cell["samples"]
                ],
            }
        )
        for cell in record["cells"]
    ]
    return PixelTrace(**{**record, "radiance": tuple(record["radiance"]), "cells": cells})
