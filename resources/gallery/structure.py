"""How alike the structure of two pictures of smoke is, whatever its outline: sliced Wasserstein distances of patches.

The slope of a spectrum is blind to phase, and so to what the eye goes by: billows, creases and rims are arrangements. Each picture of density becomes a
Laplacian pyramid (Burt and Adelson 1983); of each level, patches of 7 x 7 pixels are compared as clouds of points, by the mean distance of their sorted
projections on random directions (Rabin et al. 2011; Karras et al. 2018 use it for levels of photographs).
"""

import numpy as np

EDGE = 7
LEVELS = 4  # creases of a pixel up to billows of eight
DIRECTIONS = 192
QUANTILES = np.linspace(0, 1, 257)
SMOKE = 0.04  # mean density of a patch that counts


def halved(image: np.ndarray) -> np.ndarray:
    height, width = (edge // 2 * 2 for edge in image.shape)
    return image[:height, :width].reshape(height // 2, 2, width // 2, 2).mean((1, 3))


def doubled(image: np.ndarray, shape: tuple[int, int]) -> np.ndarray:
    padded = np.pad(image.repeat(2, 0).repeat(2, 1), 1, mode="edge")
    smooth = sum(padded[1 + y : padded.shape[0] - 1 + y, 1 + x : padded.shape[1] - 1 + x] * (2 - abs(y)) * (2 - abs(x)) for y in (-1, 0, 1) for x in (-1, 0, 1)) / 16
    return np.pad(smooth, ((0, shape[0] - smooth.shape[0]), (0, shape[1] - smooth.shape[1])), mode="edge")


def patches(detail: np.ndarray, density: np.ndarray) -> np.ndarray:
    """Those with smoke, as rows; each level has a mean square of 1, so that thin smoke is measured as dense smoke is."""
    windows = np.lib.stride_tricks.sliding_window_view(detail, (EDGE, EDGE))[::2, ::2]
    weight = np.lib.stride_tricks.sliding_window_view(density, (EDGE, EDGE))[::2, ::2].mean((2, 3))
    rows = windows[weight > SMOKE].reshape(-1, EDGE * EDGE)
    return rows / max(np.sqrt((rows**2).mean()), 1e-9) if len(rows) else rows


def distances(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Of two pictures of density, from the finest level to the coarsest: 0 for what is alike, about 0.3 for what has nothing in common.

    Not a number for a level at which one of them has no patch with smoke. Pictures of different smoke, or at a different scale, are as far apart as good
    and bad pictures of one: only distances to the same reference can be compared.
    """
    directions = np.random.default_rng(1).normal(size=(EDGE * EDGE, DIRECTIONS))
    directions /= np.linalg.norm(directions, axis=0)
    found = []
    for _ in range(LEVELS):
        clouds = [patches(image - doubled(halved(image), image.shape), image) for image in (one, other)]
        if all(len(cloud) for cloud in clouds):
            sorted_projections = [np.quantile(cloud @ directions, QUANTILES, axis=0) for cloud in clouds]
            found.append(float(np.abs(sorted_projections[0] - sorted_projections[1]).mean()))
        else:
            found.append(float("nan"))
        one, other = halved(one), halved(other)
    return np.array(found)


def structure_between(one: np.ndarray, other: np.ndarray) -> float:
    """The mean of the levels that both have, without the finest, which in path-traced references is the grain of few samples; not a number when there is none."""
    found = distances(one, other)[1:]
    known = found[~np.isnan(found)]
    return float(known.mean()) if len(known) else float("nan")
