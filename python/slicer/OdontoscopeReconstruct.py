"""Odontoscope in 3D Slicer: a segmentation, or the contours of a structure set, to certified models.

A scripted module in one file: Edit > Application Settings > Modules > Additional module paths, the folder of this file. It runs the program
`odontoscope`, which must be installed (Slicer has a Python of its own, into which the package cannot be built), and talks to it by files:

    a segmentation    saved by Slicer as .seg.nrrd: labels with names; a segment that overlaps another makes Slicer write layers, which are refused
    contours          of segments that came from a structure set (SlicerRT's "Planar contour"), as a contour stack
    a file            what `odontoscope reconstruct` reads: RTSTRUCT, contours of other programs, volumes with --iso
    models            come back as .vtp, one model for each structure, in the segment's colour

Slicer's coordinates run right, anterior, superior; those of the program, as in its files, left, posterior, superior.
"""
import json
import os
import shlex
import shutil
import subprocess

import ctk
import qt
import slicer
import vtk
from slicer.ScriptedLoadableModule import ScriptedLoadableModule, ScriptedLoadableModuleLogic, ScriptedLoadableModuleWidget

PLANAR_CONTOURS = "Planar contour"
SETTING = "Odontoscope/Program"


class OdontoscopeReconstruct(ScriptedLoadableModule):
    def __init__(self, parent):
        ScriptedLoadableModule.__init__(self, parent)
        parent.title = "Odontoscope: certified models"
        parent.categories = ["Surface Models"]
        parent.dependencies = ["Segmentations"]
        parent.contributors = ["Odontoscope"]
        parent.helpText = ("Solid, closed, outward facing models of teeth (and of whatever else is sliced) from segmentations and contours. "
                           "The verdict says whether every slab came out as contours and links imply.")
        parent.acknowledgementText = "GPL-3.0-or-later"


class Failed(Exception):
    """What a person is told."""


class OdontoscopeReconstructLogic(ScriptedLoadableModuleLogic):
    def program(self):
        """The program's path. Failed if there is none."""
        chosen = slicer.app.userSettings().value(SETTING) or ""
        found = shutil.which(chosen or "odontoscope", path=slicer.util.startupEnvironment().get("PATH"))
        if not found:
            raise Failed(f"{chosen or 'odontoscope'} is not there. Install Odontoscope, and choose its program.")
        return found

    def run(self, *words):
        """What the program printed. Slicer's own libraries are kept from it."""
        done = subprocess.run([self.program(), "--quiet", *words], env=slicer.util.startupEnvironment(), stdin=subprocess.DEVNULL, capture_output=True, text=True)
        if done.returncode != 0:
            raise Failed(done.stderr.strip() or f"odontoscope ended with {done.returncode}")
        return done.stderr.strip()

    def reconstruct(self, source, options=""):
        """Models and the report of a segmentation node, or of a file. Whatever fails is Failed, and leaves no model behind.

        source: a vtkMRMLSegmentationNode, or a file's name. options: of `odontoscope reconstruct`, as one types them.
        """
        folder = slicer.util.tempDirectory("odontoscope")
        try:
            given, colours = (self.exported(source, folder) if hasattr(source, "GetSegmentation") else ([str(source)], {}))
            models, report = os.path.join(folder, "models.vtp"), os.path.join(folder, "report.json")
            try:
                typed = shlex.split(options)
            except ValueError as error:
                raise Failed(f"The options cannot be understood: {error}") from error
            told = self.run("reconstruct", *given, *typed, "-o", models, "--report", report)
            with open(report, encoding="utf-8") as opened:
                return self.loaded(models, colours), {**json.load(opened), "told": told}
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    # --- there: what the program reads ---

    def exported(self, node, folder):
        """Words for the program, and the colour of each segment by its name. Contours go first: they are what was drawn."""
        segmentation = node.GetSegmentation()
        segments = [segmentation.GetNthSegment(n) for n in range(segmentation.GetNumberOfSegments())]
        if not segments:
            raise Failed(f"{node.GetName()} has no segments")
        names = [segment.GetName() for segment in segments]
        if len(set(names)) != len(names):
            raise Failed("Two segments have one name. Rename one.")
        colours = {segment.GetName(): segment.GetColor() for segment in segments}
        if all(segment.GetRepresentation(PLANAR_CONTOURS) for segment in segments):
            file = os.path.join(folder, "contours.json")
            with open(file, "w", encoding="utf-8") as opened:
                json.dump(contour_stack(segments), opened)
            return [file], colours
        file = os.path.join(folder, "labels.seg.nrrd")
        if not slicer.util.saveNode(node, file):
            raise Failed(f"Slicer could not save {node.GetName()}")
        return [file, *(word for name in names for word in ("--label", name))], colours

    # --- and back ---

    def loaded(self, file, colours):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(file)
        reader.Update()
        made = []
        for name, surface in surfaces_of(reader.GetOutput()):
            node = slicer.mrmlScene.AddNewNodeByClass("vtkMRMLModelNode", name)
            node.SetAndObservePolyData(surface)
            node.CreateDefaultDisplayNodes()
            if name in colours:
                node.GetDisplayNode().SetColor(*colours[name])
            made.append(node)
        return made


def contour_stack(segments):
    """Contours that Slicer holds, right-anterior-superior, as a contour stack, left-posterior-superior. Failed for those that do not lie in planes of z."""
    slices = {}
    for segment in segments:
        data = segment.GetRepresentation(PLANAR_CONTOURS)
        for cell in range(data.GetNumberOfCells()):
            points = [data.GetPoint(data.GetCell(cell).GetPointId(n)) for n in range(data.GetCell(cell).GetNumberOfPoints())]
            if len(points) > 1 and points[0] == points[-1]:
                points.pop()
            if len(points) < 3:
                continue
            heights = [z for _, _, z in points]
            if max(heights) - min(heights) > 1e-3:
                raise Failed(f"A contour of {segment.GetName()} does not lie in an axial plane. Give the structure set's file instead.")
            slices.setdefault(round(sum(heights) / len(heights), 4), []).append({"structure": segment.GetName(), "points": [[-x, -y] for x, y, _ in points]})
    return {"format": "odontoscope.contours", "version": 1, "unit": "mm", "slices": [{"z": z, "contours": slices[z]} for z in sorted(slices)]}


def surfaces_of(polydata):
    """(name, surface in Slicer's coordinates) of each structure in one of the program's .vtp files: cell data "structure" counts from 1, field data "structure NAME" says which is which."""
    fields = polydata.GetFieldData()
    names = {}
    for n in range(fields.GetNumberOfArrays()):
        array = fields.GetArray(n)
        if array is not None and array.GetName().startswith("structure "):
            names[int(array.GetTuple1(0))] = array.GetName()[len("structure "):]
    turn = vtk.vtkTransform()
    turn.Scale(-1, -1, 1)   # a half turn about z: inside and outside stay as they are
    for number in sorted(names):
        chosen = vtk.vtkThreshold()
        chosen.SetInputData(polydata)
        chosen.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_CELLS, "structure")
        chosen.SetLowerThreshold(number)
        chosen.SetUpperThreshold(number)
        chosen.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_BETWEEN)
        surface, turned = vtk.vtkGeometryFilter(), vtk.vtkTransformPolyDataFilter()
        surface.SetInputConnection(chosen.GetOutputPort())
        turned.SetInputConnection(surface.GetOutputPort())
        turned.SetTransform(turn)
        turned.Update()
        yield names[number], turned.GetOutput()


class OdontoscopeReconstructWidget(ScriptedLoadableModuleWidget):
    def setup(self):
        ScriptedLoadableModuleWidget.setup(self)
        self.logic = OdontoscopeReconstructLogic()
        box = ctk.ctkCollapsibleButton()
        box.text = "Certified models"
        self.layout.addWidget(box)
        form = qt.QFormLayout(box)

        self.segmentation = slicer.qMRMLNodeComboBox()
        self.segmentation.nodeTypes = ["vtkMRMLSegmentationNode"]
        self.segmentation.noneEnabled = True
        self.segmentation.addEnabled = False
        self.segmentation.setMRMLScene(slicer.mrmlScene)
        form.addRow("Segmentation:", self.segmentation)
        self.file = ctk.ctkPathLineEdit()
        self.file.toolTip = "Instead of a segmentation: a structure set (RTSTRUCT), or contours of another program"
        form.addRow("or file:", self.file)
        self.options = qt.QLineEdit()
        self.options.toolTip = "Of odontoscope reconstruct: --smooth 0.1 --min-area 4 --partition --triangles 20000 --repair"
        form.addRow("Options:", self.options)
        self.program = ctk.ctkPathLineEdit()
        self.program.currentPath = slicer.app.userSettings().value(SETTING) or ""
        self.program.toolTip = "The program odontoscope; empty: the one in PATH"
        form.addRow("Program:", self.program)
        self.apply = qt.QPushButton("Reconstruct")
        self.apply.clicked.connect(self.on_apply)
        form.addRow(self.apply)
        self.verdict = qt.QLabel("")
        self.verdict.wordWrap = True
        form.addRow(self.verdict)
        self.layout.addStretch(1)

    def on_apply(self):
        slicer.app.userSettings().setValue(SETTING, self.program.currentPath)
        source = self.segmentation.currentNode() or self.file.currentPath
        if not source:
            self.verdict.text = "Choose a segmentation, or a file."
            return
        try:
            with slicer.util.WaitCursor():
                models, report = self.logic.reconstruct(source, self.options.text)
        except Failed as error:
            self.verdict.text = str(error)
            slicer.util.errorDisplay(str(error))
            return
        self.verdict.text = verdict_in_words(report, models)


def verdict_in_words(report, models):
    words = [f"{report['verdict'].capitalize()}: {', '.join(node.GetName() for node in models)}."]
    words += [item["words"] for item in report.get("attention", [])[:5] if "words" in item]
    return "\n".join([*words, *([report["told"]] if report["told"] else [])])
