"""Paint as procedural materials, and how their colours are baked into a vehicle's pictures."""

import math

import bpy

# Linear colours.
DUST = (0.33, 0.235, 0.13)
BARE = (0.20, 0.18, 0.155)
DEEP = (0.040, 0.034, 0.027)
PACK_MARGIN = 0.0012


class Material:
    """What a part is made of, as nodes: a colour, and occlusion, roughness and metal."""

    def __init__(
        self,
        name,
        base,
        others=(),
        rough=0.8,
        metal=0.0,
        wear=0.0,
        dust=0.5,
        grime=0.35,
        scale=0.62,
    ):
        """`others` are further colours of the camouflage, `wear` how bare edges are."""
        self.made = bpy.data.materials.new(name)
        self.made.use_nodes = True
        self.tree = self.made.node_tree
        self.geometry = self._node("ShaderNodeNewGeometry")
        self.edge = self._edges() if wear else None
        colour = base
        for number, other in enumerate(others):
            spots = self._noise(scale, 3, 0.518, 0.524, shift=17.0 * number)
            colour = self._mix(spots, colour, other)
        darker = tuple(c * 0.68 for c in base)
        colour = self._mix(self._times(self._noise(3.0, 6, 0.35, 0.75), grime), colour, darker)
        colour = self._mix(
            self._times(self._noise(34.0, 3, 0.5, 0.75), grime * 0.5), colour, darker
        )
        if grime > 0.2:
            colour = self._mix(self._times(self._runs(), grime * 0.75), colour, DEEP)
        open_share = self._occlusion(0.35)
        hole = self._range(open_share, 0.9, 0.3)
        colour = self._mix(self._times(hole, 0.55), colour, DEEP)
        if wear:
            chips = self._times(self._times(self.edge, self._noise(11.0, 7, 0.46, 0.60)), wear)
            colour = self._mix(chips, colour, BARE)
        low = self._range(self._split(self.geometry.outputs["Position"], 2), 1.6, 0.1)
        colour = self._mix(
            self._times(self._times(low, self._noise(5.0, 7, 0.25, 0.65)), dust), colour, DUST
        )
        flat = self._range(self._split(self.geometry.outputs["Normal"], 2), 0.75, 1.0)
        laid = self._times(self._times(flat, self._noise(4.0, 6, 0.32, 0.7)), dust * 0.55)
        colour = self._mix(laid, colour, DUST)
        self.colour = self._emission(colour)
        self.surface = self._emission(
            self._combine(self._range(open_share, 0.0, 0.92), rough, metal)
        )

    def use(self, socket):
        """Shows the colour or the surface, for baking."""
        self.tree.links.new(socket, self.tree.nodes["Material Output"].inputs[0])

    def paint_into(self, image):
        """Makes an image the target of the bake."""
        node = self._node("ShaderNodeTexImage")
        node.image = image
        self.tree.nodes.active = node

    def _node(self, kind):
        return self.tree.nodes.new(kind)

    def _link(self, source, target):
        if isinstance(source, tuple):
            target.default_value = (*source, 1) if len(target.default_value) == 4 else source
        elif isinstance(source, float):
            target.default_value = source
        else:
            self.tree.links.new(source, target)

    def _range(self, source, low, high):
        node = self._node("ShaderNodeMapRange")
        node.inputs[1].default_value, node.inputs[2].default_value = low, high
        self._link(source, node.inputs[0])
        return node.outputs[0]

    def _place(self, shift=0.0, stretch=(1, 1, 1)):
        node = self._node("ShaderNodeMapping")
        node.inputs["Location"].default_value = (shift, shift * 0.7, -shift)
        node.inputs["Scale"].default_value = stretch
        self._link(self.geometry.outputs["Position"], node.inputs["Vector"])
        return node.outputs[0]

    def _noise(self, scale, detail, low, high, shift=0.0, stretch=(1, 1, 1)):
        node = self._node("ShaderNodeTexNoise")
        node.inputs["Scale"].default_value, node.inputs["Detail"].default_value = scale, detail
        self._link(self._place(shift, stretch), node.inputs["Vector"])
        return self._range(node.outputs["Fac"], low, high)

    def _runs(self):
        """Dirt that rain has drawn down upright faces."""
        steep = self._range(self._split(self.geometry.outputs["Normal"], 2), 0.6, 0.1)
        return self._times(self._noise(1.0, 4, 0.55, 0.75, 5.0, (9, 9, 0.7)), steep)

    def _mix(self, share, one, other):
        node = self._node("ShaderNodeMix")
        node.data_type = "RGBA"
        self._link(share, node.inputs[0])
        self._link(one, node.inputs[6])
        self._link(other, node.inputs[7])
        return node.outputs[2]

    def _times(self, one, other):
        node = self._node("ShaderNodeMath")
        node.operation, node.use_clamp = "MULTIPLY", True
        self._link(one, node.inputs[0])
        self._link(other, node.inputs[1])
        return node.outputs[0]

    def _split(self, source, number):
        node = self._node("ShaderNodeSeparateXYZ")
        self._link(source, node.inputs[0])
        return node.outputs[number]

    def _combine(self, *sources):
        node = self._node("ShaderNodeCombineXYZ")
        for number, source in enumerate(sources):
            self._link(source, node.inputs[number])
        return node.outputs[0]

    def _occlusion(self, reach):
        node = self._node("ShaderNodeAmbientOcclusion")
        node.samples, node.inputs["Distance"].default_value = 10, reach
        return node.outputs["AO"]

    def _edges(self):
        bevel = self._node("ShaderNodeBevel")
        bevel.samples, bevel.inputs["Radius"].default_value = 6, 0.016
        dot = self._node("ShaderNodeVectorMath")
        dot.operation = "DOT_PRODUCT"
        self._link(bevel.outputs[0], dot.inputs[0])
        self._link(self.geometry.outputs["Normal"], dot.inputs[1])
        return self._range(dot.outputs["Value"], 0.995, 0.90)

    def _emission(self, colour):
        node = self._node("ShaderNodeEmission")
        self._link(colour, node.inputs[0])
        return node.outputs[0]


def military(tan=(0.275, 0.195, 0.105)):
    """The materials of a vehicle in desert paint, by name."""
    olive, brown = (0.085, 0.088, 0.044), (0.120, 0.070, 0.038)
    made = [
        Material("Paint", tan, (olive, brown), 0.78, 0.0, wear=0.85),
        Material("Plain", tan, (), 0.78, 0.0, wear=0.85),
        Material("Steel", (0.085, 0.078, 0.070), (), 0.5, 0.7, wear=0.8, dust=0.8),
        Material("Rubber", (0.030, 0.030, 0.030), (), 0.92, 0.0, dust=0.75),
        Material("Dark", (0.030, 0.028, 0.027), (), 0.55, 0.3, wear=0.5, dust=0.2),
        Material(
            "Canvas", (0.135, 0.125, 0.070), ((0.19, 0.15, 0.085),), 0.97, 0.0, dust=0.5, scale=2.5
        ),
        Material("Wood", (0.21, 0.115, 0.050), (), 0.8, 0.0, wear=0.3, dust=0.3),
        Material("Glass", (0.012, 0.022, 0.028), (), 0.08, 0.0, dust=0.12, grime=0.1),
        Material("Lens", (0.55, 0.55, 0.50), (), 0.12, 0.0, dust=0.15, grime=0.1),
        Material("Red", (0.30, 0.018, 0.012), (), 0.25, 0.0, dust=0.2, grime=0.1),
        Material("Inside", (0.40, 0.44, 0.38), (), 0.6, 0.0, dust=0.0, wear=0.3),
        Material("Stencil", (0.62, 0.58, 0.48), (), 0.85, 0.0, dust=0.3, grime=0.6),
    ]
    return {m.made.name: m for m in made}


def _unwrap(parts):
    bpy.ops.object.select_all(action="DESELECT")
    for part in parts:
        part.select_set(True)
    bpy.context.view_layer.objects.active = parts[0]
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.uv.smart_project(
        angle_limit=math.radians(60), island_margin=PACK_MARGIN, area_weight=0.0
    )
    bpy.ops.uv.average_islands_scale()
    bpy.ops.uv.pack_islands(margin=PACK_MARGIN)
    bpy.ops.object.mode_set(mode="OBJECT")


def bake(materials, name, folder, size, samples=8):
    """Unwraps all parts into one sheet and bakes NAME_albedo.jpg and NAME_orm.jpg."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.samples, scene.cycles.use_denoising = samples, False
    scene.render.bake.margin = 6
    scene.view_settings.view_transform = "Standard"
    found = {}
    for part in scene.objects:
        if part.type == "MESH":
            found.setdefault(part.data.name, part)
    parts = list(found.values())
    _unwrap(parts)
    for kind, edge in (("albedo", size), ("orm", size // 2)):
        image = bpy.data.images.new(f"{name}_{kind}", edge, edge)
        image.colorspace_settings.name = "sRGB" if kind == "albedo" else "Non-Color"
        for material in materials.values():
            material.use(material.colour if kind == "albedo" else material.surface)
            material.paint_into(image)
        bpy.ops.object.bake(type="EMIT", use_clear=True)
        image.filepath_raw = str(folder / f"{name}_{kind}.jpg")
        image.file_format = "JPEG"
        scene.render.image_settings.file_format = "JPEG"
        scene.render.image_settings.quality = 86
        image.save(quality=86)
    _make_one(parts, name)


def _make_one(parts, name):
    """One sheet, one material: one draw a part."""
    sheet = bpy.data.materials.new(name)
    for part in parts:
        part.data.materials.clear()
        part.data.materials.append(sheet)
        for face in part.data.polygons:
            face.material_index = 0
