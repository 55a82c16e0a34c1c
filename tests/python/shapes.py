"""Contours with known truth, made in code."""
import numpy as np
import odontoscope

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]


def circle(x=0.0, y=0.0, radius=1.0, corners=24):
    turn = 2 * np.pi * np.arange(corners) / corners
    return np.column_stack([x + radius * np.cos(turn), y + radius * np.sin(turn)])


def box():
    """4 x 4 x 1 mm."""
    return [(0, SQUARE), (1, SQUARE)]


def root(slices=8):
    """A root with a canal that is closed at both ends: one piece with one cavity, both of genus 0."""
    rows = []
    for n in range(slices):
        rows.append((0.5 * n, circle(radius=2)))
        if 0 < n < slices - 1:
            rows.append((0.5 * n, circle(radius=0.8)))
    return rows


def ball(size=15):
    """Values that grow to the middle: the surface at 0 is a ball of 5 voxels' radius."""
    middle = size // 2
    k, j, i = np.indices((size, size, size)) - middle
    return (5 - np.sqrt(i * i + j * j + k * k)).astype(np.float32)


def volume_file(file):
    """A ball of dentine around a denser core, in air: the Volume, and the NRRD file of it."""
    k, j, i = np.mgrid[0:24, 0:20, 0:22]
    far = np.sqrt((0.3 * (i - 10.5)) ** 2 + (0.3 * (j - 9.5)) ** 2 + (0.25 * (k - 11.5)) ** 2)
    values = np.where(far < 1.1, 190, np.where(far < 2.3, 110 + 3 * (k % 3), 15)).astype("<f4")
    header = "NRRD0004\ntype: float\ndimension: 3\nsizes: 22 20 24\nencoding: raw\nendian: little\nspace: left-posterior-superior\n" \
             "space directions: (0.3,0,0) (0,0.3,0) (0,0,0.25)\nspace origin: (1,2,3)\n\n"
    file.write_bytes(header.encode() + values.tobytes())
    return odontoscope.Volume(values, spacing=(0.3, 0.3, 0.25), origin=(1, 2, 3)), file
