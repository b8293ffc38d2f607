"""Laced boots: leather, laces and soles."""

from .boot_laces import add_laces
from .boot_sole import add_sole
from .boot_upper import add_upper
from .kit import Kit
from .quad_mesh import QuadMesh


def add_boot(kit: Kit, both_feet: QuadMesh, side: str) -> None:
    """Add one boot, made of the tights' foot."""
    upper = add_upper(kit, both_feet, side)
    leather = kit.parts[-1]
    add_laces(kit, upper, leather)
    add_sole(kit, upper)
