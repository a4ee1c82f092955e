#!/usr/bin/env python3
"""Prints what VTK's own reader finds in state files of mpmrun, as a table: file, points, cells, bounds, array, low, high.

usage: read_state.py FILE ...
"""
import sys

from vtkmodules.vtkIOHDF import vtkHDFReader

print("file", "points", "cells", "x_low", "x_high", "y_low", "y_high", "array", "low", "high", sep="\t")
for file in sys.argv[1:]:
    reader = vtkHDFReader()
    if not reader.CanReadFile(file):
        sys.exit(f"{file}: VTK cannot read it")
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    for number in range(grid.GetPointData().GetNumberOfArrays()):
        array = grid.GetPointData().GetArray(number)
        counts = (grid.GetNumberOfPoints(), grid.GetNumberOfCells())
        print(file, *counts, *grid.GetBounds()[:4], array.GetName(), *array.GetRange(), sep="\t")
