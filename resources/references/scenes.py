"""The numbers of the reference pictures, for make.py.

Lengths in metres, y up where a place or direction is ours, frames of 1/24 s. What a scene does not name is as in DEFAULT.
"""

DEFAULT = {
    # The air: whole cells along the longest edge of the box, width, height and depth of the box, whose floor is at 0.
    "cells": 64,
    "box": (3.2, 6.0, 3.2),
    "ceiling": False,  # whether the top is closed, as the floor is
    "vorticity": 0.4,
    "turbulence": 0.15,  # strength of a field of force that keeps things uneven; its size is 1 m
    "lift": (3.0, 9.0),  # of smoke (it falls when negative) and of heat
    "fades": 0,  # frames that smoke lasts; 0: for ever
    "burning": None,  # of flames: rate, smoke, vorticity, highest temperature
    # The source: a cylinder or a ball on the floor, patchy by a texture of clouds; what it gives off is as in Blender's manual, speeds are m/s.
    "source": "cylinder",
    "radius": 0.3,
    "thickness": 0.25,
    "clouds": 0.25,  # size of the texture's patches
    "emits": "SMOKE",
    "density": 1.0,
    "fuel": 1.0,
    "heat": 1.5,
    "speed": (1.5, 0.0),  # upwards, outwards
    "until": None,  # the last frame that gives anything off
    # The picture: light that the smoke takes away in 1/m for a density of 1, colour, strength of the flames, and a camera that is pitched down by 4 degrees.
    "extinction": 12.0,
    "albedo": 0.82,
    "flames": 0.0,
    "sun": 4.0,
    "target": (0.0, 2.9, 0.0),
    "distance": 9.6,
    "moments": (30, 54, 80),
}
SCENES = {
    "plume": {},
    "explosion": {
        "cells": 44, "box": (4.8, 4.8, 4.8), "turbulence": 0.4, "lift": (0.0, 7.0), "burning": (0.35, 2.5, 0.6, 3.0), "source": "ball", "radius": 0.4, "emits": "BOTH", "density": 2.0,
        "fuel": 3.0, "heat": 3.0, "speed": (5.0, 6.0), "until": 5, "extinction": 22.0, "albedo": 0.35, "flames": 30.0, "target": (0.0, 2.1, 0.0), "distance": 7.8, "moments": (8, 20, 40),
    },
    "ceiling": {"cells": 64, "box": (5.2, 2.6, 5.2), "ceiling": True, "target": (0.0, 1.35, 0.0), "distance": 8.0, "moments": (36, 54, 72)},
    "fire": {
        "cells": 44, "box": (2.2, 4.2, 2.2), "turbulence": 0.4, "lift": (1.0, 7.0), "burning": (0.4, 0.5, 0.6, 3.0), "radius": 0.36, "clouds": 0.15, "emits": "FIRE", "fuel": 2.0, "heat": 2.0,
        "speed": (0.5, 0.0), "fades": 40, "extinction": 15.0, "albedo": 0.4, "flames": 8.0, "sun": 1.0, "target": (0.0, 1.9, 0.0), "distance": 6.2, "moments": (36, 48, 60),
    },
}

# As in our default preset.
PITCH = 4.0  # degrees
FOCAL_LENGTH = 50.0  # mm, on a sensor of 36 mm
SUN_DIRECTION = (-0.6, -0.64, -0.48)  # that its light travels in
SUN_COLOUR = (1.0, 0.96, 0.9)
SKY = (0.42, 0.52, 0.68)
GROUND = (0.2, 0.18, 0.16)
ANISOTROPY = 0.3


def numbers(name: str) -> dict:
    """Those of a scene, whole."""
    return DEFAULT | SCENES[name]
