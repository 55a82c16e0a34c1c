"""How long does a picture of a volume take, beside vtkGPUVolumeRayCastMapper's of the same volume?

    xvfb-run -a /usr/bin/python3 tests/benchmark/volume_against_vtk.py build/release/tests/benchmark/odontoscope_volume_benchmark [CT.nrrd] [--large]

Debian's python3-vtk9 and python3-numpy. Both draw 1280 x 720 pixels with the same OpenGL, from one camera, lit, with one transfer function and steps of one length, in turns: made-up
volumes of 256^3 (and with --large 512^3) values, and the CT if it is named. Printed are the medians, and ours over VTK's in processor time and by the wall clock. The bar is
0.8 in processor time; the exit status tells whether it is met. Besides, a still of four samples a pixel, as many rays as it needs and a ray through each sample, and by how much these differ.
Pictures of both go to the working directory, to be looked at.
"""
import gzip
import json
import os
import subprocess
import sys
import tempfile
import time
from statistics import median

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk

BAR, ROUNDS = 0.8, 3


def made_up(side):
    """A tooth of three greys with a hollow, in a box of air with a little noise: uint8, z first."""
    z, y, x = numpy.meshgrid(*(numpy.linspace(-1, 1, side, dtype=numpy.float32),) * 3, indexing="ij", sparse=True)
    edge = lambda distance: 1 / (1 + numpy.exp(numpy.clip(16 * (distance - 1), -50, 50)))
    body = edge(numpy.sqrt((x / 0.55) ** 2 + (y / 0.45) ** 2 + (z / 0.9) ** 2) + 0.05 * numpy.sin(9 * x) * numpy.cos(7 * z))
    crown = edge(numpy.sqrt((x / 0.56) ** 2 + (y / 0.47) ** 2 + ((z - 0.5) / 0.42) ** 2))
    hollow = edge(numpy.sqrt((x / 0.15) ** 2 + (y / 0.12) ** 2 + ((z + 0.1) / 0.55) ** 2))
    values = 40 + 120 * body + 70 * body * crown - 130 * body * hollow
    values += numpy.random.default_rng(5).integers(-3, 4, values.shape, dtype=numpy.int8)
    return numpy.clip(values, 0, 255).astype(numpy.uint8)


def write_nrrd(path, values, spacing):
    sizes = " ".join(str(n) for n in reversed(values.shape))
    with open(path, "wb") as file:
        file.write(f"NRRD0004\ntype: uint8\ndimension: 3\nsizes: {sizes}\nspacings: {spacing} {spacing} {spacing}\nencoding: raw\n\n".encode())
        file.write(values.tobytes())


def image_of(path):
    """Of an NRRD file with its values behind the header, eight bits, as they are or gzipped."""
    with open(path, "rb") as file:
        head, _, body = file.read().partition(b"\n\n")
    said = dict(line.split(": ", 1) for line in head.decode().splitlines() if ": " in line)
    values = numpy.frombuffer(gzip.decompress(body) if said["encoding"].startswith("gz") else body, numpy.uint8)
    image = vtk.vtkImageData()
    image.SetDimensions([int(word) for word in said["sizes"].split()])
    image.SetSpacing([float(word) for word in said.get("spacings", "1 1 1").split()])
    scalars = numpy_to_vtk(values, deep=True)
    scalars.SetName("values")
    image.GetPointData().SetScalars(scalars)
    return image


class Theirs:
    def __init__(self, image, camera, step, transfer):
        colours, opacities = vtk.vtkColorTransferFunction(), vtk.vtkPiecewiseFunction()
        colours.SetColorSpaceToRGB()
        for value, red, green, blue, _ in transfer:
            colours.AddRGBPoint(value, red, green, blue)
        values, extinctions = [point[0] for point in transfer], [point[4] for point in transfer]
        for value in numpy.linspace(*image.GetScalarRange(), 512):
            opacities.AddPoint(value, 1 - numpy.exp(-numpy.interp(value, values, extinctions)))   # of a millimetre
        look = vtk.vtkVolumeProperty()
        look.SetColor(colours)
        look.SetScalarOpacity(opacities)
        look.SetInterpolationTypeToLinear()
        look.ShadeOn()
        mapper = vtk.vtkGPUVolumeRayCastMapper()
        mapper.SetInputData(image)
        mapper.AutoAdjustSampleDistancesOff()
        mapper.LockSampleDistanceToInputSpacingOff()
        mapper.SetSampleDistance(step)
        mapper.SetImageSampleDistance(1)
        mapper.UseJitteringOff()
        volume = vtk.vtkVolume()
        volume.SetMapper(mapper)
        volume.SetProperty(look)
        renderer = vtk.vtkRenderer()
        renderer.AddVolume(volume)
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(1280, 720)
        self.window.AddRenderer(renderer)
        eye = renderer.GetActiveCamera()
        position, target, up, angle = camera
        eye.SetPosition(position)
        eye.SetFocalPoint(target)
        eye.SetViewUp(up)
        eye.SetViewAngle(angle)
        renderer.ResetCameraClippingRange()
        self.draw()

    def draw(self):
        wall, processor = time.monotonic(), time.process_time()
        self.window.Render()
        self.window.WaitForCompletion()
        return 1000 * (time.monotonic() - wall), 1000 * (time.process_time() - processor)

    def save(self, path):
        grab, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
        grab.SetInput(self.window)
        writer.SetInputConnection(grab.GetOutputPort())
        writer.SetFileName(path)
        writer.Write()


def compare(program, name, path, air, dentine):
    ours = subprocess.Popen([program, path, str(air), str(dentine), f"{name}-ours.png"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    *camera, step, transfer = json.loads(ours.stdout.readline())
    theirs = Theirs(image_of(path), camera, step, transfer)
    own, other = [], []
    def drawn(how):
        ours.stdin.write(how + "\n")
        ours.stdin.flush()
        return [float(word) for word in ours.stdout.readline().split()]

    for _ in range(ROUNDS):
        own.append(drawn("draw"))
        other.append(theirs.draw())
    drawn("still")   # buffers are made
    stills, fulls = [drawn("still") for _ in range(ROUNDS)], [drawn("full") for _ in range(ROUNDS)]
    ours.stdin.close()
    ours.wait()
    theirs.save(f"{name}-vtk.png")
    (wall, processor), (their_wall, their_processor) = ([median(column) for column in zip(*times)] for times in (own, other))
    ratio = processor / their_processor
    print(f"{name}: ours {processor:.0f} ms of processor time ({wall:.0f} ms), VTK {their_processor:.0f} ms ({their_wall:.0f} ms), step {step:.3g} mm: {ratio:.2f} ({wall / their_wall:.2f} by the wall clock)")
    (still_wall, still), (full_wall, full, worst, pixels) = ([median(column) for column in zip(*times)] for times in (stills, fulls))
    print(f"  still of four samples a pixel: {still:.0f} ms of processor time ({still_wall:.0f} ms); a ray through each: {full:.0f} ms ({full_wall:.0f} ms); they differ by {worst:.0f} of 255 at most, "
          f"by more than two in {pixels:.0f} pixels")
    return ratio <= BAR


def main(program, *words):
    met = True
    with tempfile.TemporaryDirectory() as folder:
        for side in [256] + [512] * ("--large" in words):
            path = os.path.join(folder, f"{side}.nrrd")
            write_nrrd(path, made_up(side), 16 / side)
            met = compare(program, f"made-up-{side}", path, 40, 160) and met
        for path in words:
            if path != "--large":
                met = compare(program, "ct", path, 78, 164) and met
    print(f"Bar of {BAR}: " + ("met." if met else "not met."))
    return 0 if met else 1


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
