"""As much of 3D Slicer as the scripted module asks for, by its documented names: nodes, scene, settings, widgets, and files as Slicer saves them."""
import contextlib
import gzip
import os
import tempfile
import types

import numpy as np

PROBLEMS = []   # what a person was told in a dialog


class Segment:
    def __init__(self, name, colour, label=0, contours=None):
        self.name, self.colour, self.label, self.contours = name, colour, label, contours

    GetName = lambda self: self.name
    GetColor = lambda self: self.colour
    GetRepresentation = lambda self, kind: self.contours if kind == "Planar contour" else None


class Node:
    """A segmentation: segments, and labels of shape (slices, rows, columns) with their geometry, right-anterior-superior."""

    def __init__(self, name, segments, labels=None, spacing=(1, 1, 1), origin=(0, 0, 0)):
        self.name, self.segments, self.labels, self.spacing, self.origin = name, segments, labels, spacing, origin

    GetName = lambda self: self.name
    GetSegmentation = lambda self: self
    GetNumberOfSegments = lambda self: len(self.segments)
    GetNthSegment = lambda self, n: self.segments[n]


class ModelNode:
    def __init__(self, name):
        self.name, self.polydata, self.colour = name, None, None

    GetName = lambda self: self.name
    GetPolyData = lambda self: self.polydata
    CreateDefaultDisplayNodes = lambda self: None
    GetDisplayNode = lambda self: self

    def SetAndObservePolyData(self, polydata):
        self.polydata = polydata

    def SetColor(self, *colour):
        self.colour = colour


class Scene:
    def __init__(self):
        self.models = []

    def AddNewNodeByClass(self, kind, name):
        assert kind == "vtkMRMLModelNode"
        self.models.append(ModelNode(name))
        return self.models[-1]


class Settings(dict):
    value = dict.get
    setValue = dict.__setitem__


class Widget:
    """Any of Qt's and Slicer's widgets: what is not set is empty, signals are called by hand."""

    def __init__(self, *_):
        self.text, self.currentPath, self.node = "", "", None
        self.clicked = types.SimpleNamespace(connect=lambda slot: setattr(self, "click", slot))

    currentNode = lambda self: self.node
    setMRMLScene = addRow = addWidget = addStretch = lambda self, *_: None


def saved(node, file):
    """A .seg.nrrd as Slicer 5 writes it: left-posterior-superior, axes turned rather than voxels, names in keys."""
    slices, rows, columns = node.labels.shape
    (sx, sy, sz), (ox, oy, oz) = node.spacing, node.origin
    head = ["NRRD0004", "# Complete NRRD file format specification at:", "# http://teem.sourceforge.net/nrrd/format.html", "type: unsigned char", "dimension: 3",
            "space: left-posterior-superior", f"sizes: {columns} {rows} {slices}", f"space directions: ({-sx},0,0) (0,{-sy},0) (0,0,{sz})", "kinds: domain domain domain", "encoding: gzip",
            f"space origin: ({-ox},{-oy},{oz})"]
    for n, segment in enumerate(node.segments):
        head += [f"Segment{n}_Color:={' '.join(map(str, segment.colour))}", f"Segment{n}_ID:=Segment_{n + 1}", f"Segment{n}_LabelValue:={segment.label}", f"Segment{n}_Layer:=0", f"Segment{n}_Name:={segment.name}"]
    head += ["Segmentation_ContainedRepresentationNames:=Binary labelmap|", "Segmentation_MasterRepresentation:=Binary labelmap"]
    with open(file, "wb") as opened:
        opened.write(("\n".join(head) + "\n\n").encode() + gzip.compress(np.ascontiguousarray(node.labels, dtype=np.uint8).tobytes()))
    return True


mrmlScene = Scene()
qMRMLNodeComboBox = Widget
_settings = Settings()
app = types.SimpleNamespace(userSettings=lambda: _settings)
util = types.SimpleNamespace(startupEnvironment=lambda: dict(os.environ), tempDirectory=lambda key: tempfile.mkdtemp(prefix=key), saveNode=saved, errorDisplay=PROBLEMS.append,
                             WaitCursor=contextlib.nullcontext)
