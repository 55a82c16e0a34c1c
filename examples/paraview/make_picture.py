"""A tooth in ParaView, without hands: run by pvbatch or pvpython.

    pvbatch make_picture.py tooth.png --save-state tooth.pvsm     builds the pipeline, draws it and keeps it as a state file
    pvbatch make_picture.py tooth.png --state tooth.pvsm          draws a state file

The pipeline: contours of a made-up molar, each tissue filled; a solid of tetrahedra that the tissues share (a partition); the half behind the middle; beside it the
contours that it was made from. PYTHONPATH must hold the package and its folder odontoscope/paraview (docs/python.md).
"""
import argparse
import os

import odontoscope
from paraview.simple import (Clip, ColorBy, GetActiveViewOrCreate, GetColorTransferFunction, GetRenderView, GetScalarBar, LoadPlugin, LoadState, Render, SaveScreenshot, SaveState, Show, Transform)

SIZE = [900, 700]
LOOKS = ("dentine", (0.93, 0.80, 0.58)), ("pulp", (0.75, 0.20, 0.18)), ("enamel", (0.80, 0.90, 0.96))   # by cell data "structure", from 1

asked = argparse.ArgumentParser()
asked.add_argument("picture")
asked.add_argument("--state")
asked.add_argument("--save-state")
asked = asked.parse_args()
LoadPlugin(os.path.join(os.path.dirname(odontoscope.__file__), "paraview", "OdontoscopePlugin.py"), ns=globals())

if asked.state:
    LoadState(asked.state)
    view = GetRenderView()
else:
    view = GetActiveViewOrCreate("RenderView")
    contours = OdontoscopeSampleContours(registrationName="contours", Kind="molar", SliceSpacing=0.35, PointSpacing=0.5, Filled=1)   # noqa: F821 (of the plugin)
    solid = OdontoscopeContoursToTetrahedra(registrationName="solid", Input=contours, Partition="on")   # noqa: F821
    half = Clip(registrationName="half", Input=solid, ClipType="Plane")
    half.ClipType.Origin, half.ClipType.Normal = [0, 0, 10], [0, 1, 0]
    beside = Transform(registrationName="contours beside", Input=contours)
    beside.Transform.Translate = [-14, 0, 0]
    colours = GetColorTransferFunction("structure")
    colours.InterpretValuesAsCategories = 1
    colours.Annotations = [word for number, (name, _) in enumerate(LOOKS, 1) for word in (str(number), name)]
    colours.IndexedColors = [channel for _, colour in LOOKS for channel in colour]
    for source in half, beside:
        shown = Show(source, view)
        ColorBy(shown, ("CELLS", "structure"))
        shown.LineWidth = 1.5
    shown.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(colours, view)
    bar.Title, bar.TitleColor, bar.LabelColor, bar.ScalarBarLength = "", [0, 0, 0], [0, 0, 0], 0.2
    bar.WindowLocation = "Upper Right Corner"
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.ViewSize = SIZE
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-7, 62, 22], [-7, 0, 10.5], [0, 0, 1]
    view.CameraParallelProjection, view.CameraParallelScale = 1, 12
Render(view)
if asked.save_state:
    SaveState(asked.save_state)
SaveScreenshot(asked.picture, view, ImageResolution=SIZE)
