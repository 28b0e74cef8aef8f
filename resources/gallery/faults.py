"""Faults that give smoke away as a drawing of particles, each as one number of pictures of density: dots, shimmer, and repetition;
and carried, of pictures as they are seen, for detail that is drawn anew where it should go with the smoke.

The others take density as rows of numbers from 0 to 1 (alpha, or 1 - exp(-optical depth)), at the size at which it is looked at.
"""

from typing import NamedTuple

import numpy as np

FRINGE = (0.01, 0.3)  # mean density around a pixel of the fringe, where smoke thins out
DOT = 0.35  # how far a dot stands out, beside the mean density around it
ROUND = 0.4  # least curvature of a dot beside its largest: a thread has none along itself
PATCH, REACH = 20, 9  # pixels: what is looked for in the next frame, and how far it may have gone
COARSE = 6.0  # pixels, deviation of the Gauss filter that leaves a patch its detail
FLAT = 0.006  # least deviation of a patch that has any
HIGH = 3.0  # pixels, deviation of the Gauss filter above which structure is no detail


def smoothed(image: np.ndarray, deviation: float) -> np.ndarray:
    """By a Gauss filter; outside the picture is nothing."""
    reach = int(np.ceil(3 * deviation))
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) / deviation) ** 2)
    weights /= weights.sum()
    for axis in (0, 1):
        image = np.apply_along_axis(np.convolve, axis, image, weights, mode="same")
    return image


def dots(density: np.ndarray) -> float:
    """Round spots of the fringe that stand out from it, in a thousand of its pixels.

    A spot is a maximum of the density seen through a Gauss filter of a pixel, more than DOT above the mean of what lies around it (a filter of four
    pixels), whose two principal curvatures (of the Hessian matrix) are alike: Lindeberg's blobs (1998) at one scale.
    """
    near, around = smoothed(density, 1.0), smoothed(density, 4.0)
    fringe = (around > FRINGE[0]) & (around < FRINGE[1])
    inner = near[1:-1, 1:-1]
    shifts = [near[1 + y : near.shape[0] - 1 + y, 1 + x : near.shape[1] - 1 + x] for y in (-1, 0, 1) for x in (-1, 0, 1) if (y, x) != (0, 0)]
    peak = np.logical_and.reduce([inner > shifted for shifted in shifts])
    dy, dx = np.gradient(near)
    dyy, dyx = np.gradient(dy)
    dxx = np.gradient(dx, axis=1)
    middle, apart = 0.5 * (dxx + dyy), np.hypot(0.5 * (dxx - dyy), dyx)
    round_ = np.abs(middle) - apart > ROUND * (np.abs(middle) + apart)
    stands_out = near > (1.0 + DOT) * around
    spots = peak & (fringe & round_ & stands_out)[1:-1, 1:-1]
    return 1000.0 * float(spots.sum()) / max(int(fringe.sum()), 1)


def shimmer(frames: list[np.ndarray]) -> float:
    """How much of what changes from frame to frame goes back again: 0 for steady change, 2 for what comes and goes, about 1.7 for noise that is new in each frame."""
    back = [np.abs(a - 2 * b + c).mean() for a, b, c in zip(frames, frames[1:], frames[2:])]
    change = [0.5 * (np.abs(b - a).mean() + np.abs(c - b).mean()) for a, b, c in zip(frames, frames[1:], frames[2:])]
    return float(np.sum(back) / max(np.sum(change), 1e-9))


def repetition(density: np.ndarray) -> float:
    """How alike the detail is to itself at another place: the largest correlation at a distance of more than 8 pixels; 1 for a pattern that repeats."""
    detail = density - smoothed(density, HIGH)
    weight = smoothed(density, HIGH) > FRINGE[0]
    detail = np.where(weight, detail, 0.0)
    size = [2 * edge for edge in detail.shape]  # so that no end meets the other
    found = np.fft.irfft2(np.abs(np.fft.rfft2(detail, size)) ** 2, size)
    pairs = np.fft.irfft2(np.abs(np.fft.rfft2(weight.astype(float), size)) ** 2, size)
    y, x = np.indices(found.shape)
    far = np.hypot(np.minimum(y, size[0] - y), np.minimum(x, size[1] - x)) > 8
    enough = pairs > 0.25 * pairs[0, 0]
    alike = (found / np.maximum(pairs, 1.0)) / max(found[0, 0] / max(pairs[0, 0], 1.0), 1e-12)
    return float(alike[far & enough].max(initial=0.0))


def mean_of_patches(image: np.ndarray) -> np.ndarray:
    """The mean of the patch that begins at each pixel, for all that lie within."""
    sums = np.pad(image.cumsum(0).cumsum(1), ((1, 0), (1, 0)))
    return (sums[PATCH:, PATCH:] - sums[:-PATCH, PATCH:] - sums[PATCH:, :-PATCH] + sums[:-PATCH, :-PATCH]) / PATCH**2


class Carried(NamedTuple):
    share: float  # 1 for detail that goes with the smoke, about .4 for detail that is new in each frame
    pixels: float  # that it goes


def carried(one: np.ndarray, other: np.ndarray, inside: np.ndarray) -> Carried:
    """How much of the detail of a frame is there in the next, wherever it has gone, and how far it goes: the mean over patches of their largest
    correlation, and the median of the ways to it. Not numbers where no patch lies within.

    inside: where the smoke is dense, so that nothing behind it is seen
    """
    if not inside.any():
        return Carried(float("nan"), float("nan"))
    rows, columns = (np.flatnonzero(inside.any(axis)) for axis in (1, 0))
    border = PATCH + REACH
    box = tuple(slice(max(0, among[0] - border), among[-1] + 1 + border) for among in (rows, columns))
    one, other, inside = one[box], other[box], inside[box]
    detail, after = (image - smoothed(image, COARSE) for image in (one, other))
    mean, spread = mean_of_patches(detail), mean_of_patches(detail**2)
    spread = np.sqrt(np.maximum(spread - mean**2, 0.0))
    found, way = np.full(mean.shape, -1.0), np.zeros(mean.shape)
    for y in range(-REACH, REACH + 1):
        for x in range(-REACH, REACH + 1):
            moved = np.roll(after, (-y, -x), axis=(0, 1))
            its_mean = mean_of_patches(moved)
            its_spread = np.sqrt(np.maximum(mean_of_patches(moved**2) - its_mean**2, 1e-18))
            alike = (mean_of_patches(detail * moved) - mean * its_mean) / np.maximum(spread * its_spread, 1e-9)
            way = np.where(alike > found, np.hypot(x, y), way)
            found = np.maximum(found, alike)
    counts = (mean_of_patches(inside.astype(float)) > 0.999) & (spread > FLAT)
    counts[:REACH] = counts[-REACH:] = counts[:, :REACH] = counts[:, -REACH:] = False
    return Carried(float(found[counts].mean()), float(np.median(way[counts]))) if counts.any() else Carried(float("nan"), float("nan"))
