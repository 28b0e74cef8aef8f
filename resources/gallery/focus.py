"""How much contrast smoke has in each octave of sizes, and how soft its rims are: what makes a picture in or out of focus.

Contrast is the standard deviation of ln(luminance) in bands of a difference of Gauss filters, inside the body: where it is opaque, away from its rim, so
that what lies behind has no part in it.
"""

import numpy as np

from faults import smoothed

BANDS = (0.0, 1.0, 2.0, 4.0)  # pixels: under 1, 1 to 2, 2 to 4
OPAQUE = 0.97
FROM_RIM = 6  # pixels
LEAST = 1e-3  # luminance, so that black has a logarithm
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def linear(srgb: np.ndarray) -> np.ndarray:
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def eroded(mask: np.ndarray, pixels: int) -> np.ndarray:
    for _ in range(pixels):
        grown = np.pad(mask, 1)
        mask = mask & grown[:-2, 1:-1] & grown[2:, 1:-1] & grown[1:-1, :-2] & grown[1:-1, 2:]
    return mask


def contrast(rgba: np.ndarray) -> list[float]:
    """Of a picture with straight alpha, sRGB in 0 to 1: one number a band; not a number where the body has no inside."""
    inside = eroded(rgba[..., 3] > OPAQUE, FROM_RIM)
    if inside.sum() < 100:
        return [float("nan")] * (len(BANDS) - 1)
    light = np.log(np.maximum(LEAST, linear(rgba[..., :3]) @ LUMINANCE))
    light = np.where(rgba[..., 3] > 0.5, light, light[inside].mean())
    smooth = [light if deviation == 0.0 else smoothed(light, deviation) for deviation in BANDS]
    return [float((fine - coarse)[inside].std()) for fine, coarse in zip(smooth, smooth[1:])]


def rims(alpha: np.ndarray) -> list[float]:
    """Widths of the rim from 10 to 90 % of the opacity behind it, in pixels, by the slope where it is half: the 10th, 50th and 90th percentile."""
    across, down = np.gradient(smoothed(alpha, 0.5))[::-1]
    slope = np.hypot(across, down)
    rim = (alpha > 0.45) & (alpha < 0.55) & (slope > 1e-3)
    return [float(value) for value in np.percentile(0.8 / slope[rim], (10, 50, 90))] if rim.any() else [float("nan")] * 3
