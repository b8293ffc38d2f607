"""The one door to Blender's modules (GPL; needed to build the avatar, never to run the game).

`mathutils` exists only once `bpy` has been imported, so everyone takes it from here.
"""

import bpy
from mathutils import Matrix, Vector
from mathutils.bvhtree import BVHTree
from mathutils.kdtree import KDTree

__all__ = ["BVHTree", "KDTree", "Matrix", "Vector", "bpy"]
