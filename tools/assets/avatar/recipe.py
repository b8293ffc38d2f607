"""What an avatar is made of: a JSON file in `recipes/`, one for each avatar.

Colours are linear RGB. Lengths are metres.
"""

import json
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .makehuman import BodyParameters

Array = NDArray[np.float64]

RECIPES = Path(__file__).with_name("recipes")
CUTS = ("fatigues", "shirt", "polo", "suit")
"""Trousers in boots; trousers over shoes; the same with short sleeves; one piece without folds."""


@dataclass(frozen=True)
class Palette:
    """Colours of what is worn over the clothes."""

    main: Array
    """Vest, belt, helmet."""
    pouch: Array
    boots: Array
    gloves: Array
    stripe: Array
    """Of a tabard, a crest, a cap's peak."""


@dataclass(frozen=True)
class Face:
    """How the bare skin is painted."""

    tone: Array
    hair: Array
    stubble: float = 1.0
    """0 none, 1 two days, 2 a short beard."""
    brows: float = 1.0
    """How thick they are."""
    lips: float = 1.0
    """How red they are."""
    iris: Array = field(default_factory=lambda: np.array([0.12, 0.06, 0.025]))
    is_blank: bool = False
    """A face without eyes and paint: a dummy's, a mask's."""


@dataclass(frozen=True)
class Clothes:
    """The garment and what is printed on it."""

    cut: str
    pattern: str
    """A name of `patterns.PATTERNS`."""
    colours: dict[str, Array]
    """By the names that the pattern asks for."""
    is_simulated: bool
    """Whether its folds fall in Blender's cloth simulation."""


@dataclass(frozen=True)
class Recipe:
    """One avatar."""

    name: str
    title: str
    body: BodyParameters
    face: Face
    clothes: Clothes
    palette: Palette
    kit: tuple[str, ...]
    """What is worn, by the names of `wardrobe.ITEMS`, in this order."""


def recipe_names() -> list[str]:
    """Return the names of all recipes."""
    return sorted(path.stem for path in RECIPES.glob("*.json"))


def read_recipe(name: str) -> Recipe:
    """Read a recipe; raises ValueError where it says what nobody knows."""
    tree = json.loads((RECIPES / f"{name}.json").read_text())
    clothes = tree["clothes"]
    if clothes["cut"] not in CUTS:
        raise ValueError(f"{name}: a cut is one of {', '.join(CUTS)}, found {clothes['cut']}")
    face = {k: np.array(v) if isinstance(v, list) else v for k, v in tree["face"].items()}
    return Recipe(
        name=name,
        title=tree["title"],
        body=BodyParameters.from_tree(tree["body"]),
        face=Face(**face),
        clothes=Clothes(
            clothes["cut"],
            clothes["pattern"],
            {k: np.array(v) for k, v in clothes.get("colours", {}).items()},
            clothes.get("is_simulated", True),
        ),
        palette=Palette(**{k: np.array(v) for k, v in tree["palette"].items()}),
        kit=tuple(tree["kit"]),
    )
