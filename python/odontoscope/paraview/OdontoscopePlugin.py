"""Odontoscope in ParaView: contours or images of teeth to certified solids, as filters, readers and a writer.

Tools > Manage Plugins > Load New, this file; or in pvpython and pvbatch: ``LoadPlugin(".../OdontoscopePlugin.py", ns=globals())``. docs/python.md
has the details. What it does is odontoscope.vtk; here stands what ParaView shows of it: each option as a property, with the program's own words.
"""
import html
import os
import sys

try:
    import odontoscope
except ImportError:   # ParaView's Python does not know the folder that the package lies in
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
    import odontoscope  # noqa: F401
from odontoscope import vtk as _vtk
from paraview.util.vtkAlgorithm import smdomain, smproperty, smproxy


def _texts(value):
    """What a person typed into one line: names with spaces between."""
    return tuple(value.split())


def _numbers(value):
    return tuple(float(number) for number in value.replace(",", " ").split())


def _grid(value):
    return value if "x" in value else int(value)


# ParaView's scripts call a proxy by its label without the spaces.
class _Property:
    """One option on ParaView's panel: how it is entered, and what the package is given for it."""

    def __init__(self, kind, default, words, to_value, choices=(), only=None, advanced=False, file=False):
        self.kind, self.default, self.words, self.to_value = kind, default, words, to_value
        self.choices, self.only, self.advanced, self.file = choices, only, advanced, file

    def xml(self, name):
        inner = f"<Documentation>{html.escape(self.words)}</Documentation>"
        if self.kind == "Int" and self.choices:   # a tick
            inner += '<BooleanDomain name="bool"/>'
        elif self.choices:
            inner += '<StringListDomain name="choices">' + "".join(f'<String value="{choice}"/>' for choice in self.choices) + "</StringListDomain>"
        if self.file:
            inner += '<FileListDomain name="files"/>'
        if self.only:
            inner += f'<Hints><PropertyWidgetDecorator type="GenericDecorator" mode="visibility" property="Method" value="{self.only}"/></Hints>'
        panel = ' panel_visibility="advanced"' if self.advanced else ""
        return (f'<{self.kind}VectorProperty name="{name}" command="Set{name}" number_of_elements="1" default_values="{html.escape(str(self.default))}"{panel}>'
                f"{inner}</{self.kind}VectorProperty>")


def _choice(default, words, *choices, **more):
    return _Property("String", default, words, str, choices, **more)


def _text(words, to_value, default="", **more):
    return _Property("String", default, words, to_value, **more)


def _tick(words, **more):
    return _Property("Int", 0, words, bool, (0, 1), **more)


_PARTITION = {"auto": None, "on": True, "off": False}

_DT = {
    "correspondence": _choice("tracked", "When regions of neighbouring slices connect.", "tracked", "reverse", "medial", "overlap"),
    "between": _choice("blended", "What lies between the slices.", "blended", "delaunay"),
    "partition": _Property("String", "auto", "One mesh of all structures, which share their faces: auto makes one where structures share walls or overlap.", _PARTITION.get, ("auto", "on", "off")),
    "priority": _text("With partition on: who keeps the place where structures overlap, A,B", lambda text: text or None, advanced=True),
    "gap": _Property("Double", 0, "With partition on: void narrower than so many mm between two structures is closed; 0: none is", lambda gap: gap or None, advanced=True),
    "together": _text("Structures to make one solid, the inner a cavity of the outer: A,B", lambda text: text or ()),
    "links": _text("A file of links that win over the correspondence", lambda text: text or None, advanced=True, file=True),
    "link": _text("Links to make, NAME:N:B-U, with spaces between", _texts, advanced=True),
    "unlink": _text("Links to leave out, NAME:N:B-U, with spaces between", _texts, advanced=True),
    "elements": _text("Mesh anew for simulation: edges of about so many mm, or quality", lambda text: None if not text else text if text == "quality" else float(text)),
    "strict": _tick("Give nothing where the verdict is amber, or triangles is missed.", advanced=True),
    "threads": _Property("Int", 0, "Processors to use; 0: all", int, advanced=True),
    "repair": _tick("Mend contours that break the rules.", advanced=True),
}
_SURFACE = {
    "method": _choice("dt", "dt: Delaunay, certified; db: distance field and marching cubes, to compare.", "dt", "db"),
    **_DT,
    "triangles": _Property("Int", 0, "Simplify to at most so many triangles in all; 0: all are kept", lambda count: count or None),
    "grid": _text("Points of the distance field's grid: N or NxM", _grid, default="128", only="db"),
    "cases": _choice("classic", "Which table of marching cubes.", "classic", "classic-unoriented", "consistent", only="db"),
    "field": _choice("hybrid", "Which field.", "hybrid", "signed-distance", "sign", only="db"),
    "split": _text("Heights at which to split the model, mm", _numbers, only="db", advanced=True),
    "decimate": _text("Decimate to so many triangles, or max", lambda text: None if not text else text if text == "max" else int(text), only="db"),
}
_CLEAN = {
    "min_area": _text("Leave out contours that enclose less: pixels, or an area as in 0.5mm2", lambda text: text or None),
    "smooth": _Property("Double", 0, "Smooth the borders of labels, by so many mm", lambda size: size or None, advanced=True),
    "simplify": _Property("Double", 0, "Fewer points: contours may move by so many mm", lambda size: size or None, advanced=True),
    "label_names": _text("A file of names of labels, as ITK-SNAP writes it", lambda text: text or None, advanced=True, file=True),
    "crop": _text("Take this box of the volume alone: x from and to, y, z, mm", lambda text: _numbers(text) or None, advanced=True),
    "resample": _Property("Double", 0, "Voxels of so many mm along all axes; 0: as they are", lambda size: size or None, advanced=True),
    "upright": _tick("Turn what the levels bound so that its longest axis is z.", advanced=True),
}
_LEVELS = {
    "iso": _text("Of an image: the value at the surface, 120=dentine 195=enamel, or auto", lambda text: text.split() or None),
    "label": _text("Of a label map: labels with names, 2=pulp 3=enamel", lambda text: text.split() or None),
}
_READING = {
    **_LEVELS, **_CLEAN,
    "spacing": _text("Of a volume: size of a voxel, x y z, mm, instead of the file's", lambda text: _numbers(text) or None, advanced=True),
    "series": _text("Of a DICOM folder: which series", str, advanced=True),
    "spacing_z": _Property("Double", 0, "Of a mesh: cut it every so many mm", lambda step: step or None),
    "at": _text("Of a mesh: cut it at these heights, mm", _numbers, advanced=True),
    "structure": _text("Keep these structures alone, with spaces between", lambda text: text.split() or None),
    "repair": _tick("Mend contours that break the rules."),
}
_SAMPLE = {
    "kind": _choice("molar", "Which tooth.", "molar", "premolar", "incisor"),
    "slice_spacing": _Property("Double", 0, "From slice to slice, mm; 0: closer where it is steep", lambda step: step or None),
    "point_spacing": _Property("Double", 0.22, "From point to point along contours, mm", float),
    "apart": _tick("A gap of 0.03 mm between structures; without it neighbours share their walls"),
    "filled_dentine": _tick("Apart, and the pulp is no hole of the dentine, for together: dentine,pulp"),
    "filled": _tick("Every structure overlaps those within it, for partition"),
    "open_apex": _tick("Canals leave the roots through their foramen"),
}


def _with(properties):
    """Gives a class the setters of these options, and ParaView the words for them, in this order."""

    def add(cls):
        for option, one in properties.items():
            name = "".join(part.capitalize() for part in option.split("_"))
            package_sets = getattr(cls, f"Set{name}")

            def put(self, value, name=name, one=one, package_sets=package_sets):
                typed = "" if value is None else value   # ParaView has no empty text
                try:
                    package_sets(self, one.to_value(typed))
                except ValueError:
                    print(f"{name}: \"{typed}\" cannot be understood, and stays as it was. {one.words}", file=sys.stderr)

            put.__doc__ = one.words
            setattr(cls, f"Set{name}", put)
        for option, one in reversed(list(properties.items())):   # ParaView shows the last first
            smproperty.xml(one.xml("".join(part.capitalize() for part in option.split("_"))))(cls)
        cls.odontoscope_properties = tuple(properties)
        return cls

    return add


@smproxy.filter(name="OdontoscopeContoursToSurface", label="Odontoscope Contours To Surface")
@smproperty.input(name="Input")
@smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=False)
@_with(_SURFACE)
class ContoursToSurface(_vtk.ContoursToSurface):
    pass


@smproxy.filter(name="OdontoscopeContoursToTetrahedra", label="Odontoscope Contours To Tetrahedra")
@smproperty.input(name="Input")
@smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=False)
@_with(_DT)
class ContoursToTetrahedra(_vtk.ContoursToTetrahedra):
    pass


@smproxy.filter(name="OdontoscopeImageToContours", label="Odontoscope Image To Contours")
@smproperty.input(name="Input")
@smdomain.datatype(dataTypes=["vtkImageData"], composite_data_supported=False)
@_with({**_LEVELS, **_CLEAN})
class ImageToContours(_vtk.ImageToContours):
    pass


@smproxy.source(name="OdontoscopeSampleContours", label="Odontoscope Sample Contours")
@_with(_SAMPLE)
class SampleContours(_vtk.SampleContours):
    pass


@smproxy.reader(name="OdontoscopeContoursReader", label="Odontoscope Contours Reader", extensions="json csl ser jser dcm",
                file_description="Tooth contours (Odontoscope, Reconstruct, CSL, RTSTRUCT)")
@_with(_READING)
class ContoursReader(_vtk.ContoursReader):
    @smproperty.stringvector(name="FileName", panel_visibility="never")
    @smdomain.filelist()
    def SetFileName(self, name):
        _vtk.ContoursReader.SetFileName(self, "" if name in (None, "None") else name)


@smproxy.reader(name="OdontoscopeModelReader", label="Odontoscope Model Reader", extensions="glb gltf stl ply obj", file_description="Tooth model (Odontoscope)")
class ModelReader(_vtk.ModelReader):
    @smproperty.stringvector(name="FileName", panel_visibility="never")
    @smdomain.filelist()
    def SetFileName(self, name):
        _vtk.ModelReader.SetFileName(self, "" if name in (None, "None") else name)


@smproxy.writer(name="OdontoscopeContoursWriter", label="Odontoscope Contours Writer", extensions="json", file_description="Tooth contours (Odontoscope)")
@smproperty.input(name="Input")
@smdomain.datatype(dataTypes=["vtkPolyData"], composite_data_supported=False)
@_with({"repair": _READING["repair"]})
class ContoursWriter(_vtk.ContoursWriter):
    @smproperty.stringvector(name="FileName", panel_visibility="never")
    @smdomain.filelist()
    def SetFileName(self, name):
        _vtk.ContoursWriter.SetFileName(self, "" if name in (None, "None") else name)
