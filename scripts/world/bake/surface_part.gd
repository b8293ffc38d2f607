class_name SurfacePart
extends RefCounted
## A part of a level's surfaces: what is drawn, lit and hidden as one.

## Edge of the squares whose small blocks are one part, and whose roofs are, m.
const SQUARE_M: float = 16.0
## Longest key that is read, characters.
const MAX_KEY: int = 200

## Names it; the same on all machines.
var key: String = ""
## Its faces, in the level's frame.
var mesh: BlockMesh = null


## The parts of all blocks below a level's root, in the order of the tree.
static func gather(p_level: Node3D) -> Array[SurfacePart]:
	var by_key: Dictionary[String, SurfacePart] = {}
	for node: Node in p_level.find_children("*", "StaticBody3D", true, false):
		var block: KitBlock = node as KitBlock
		if block == null or not block.is_merged() or not _is_shown(block, p_level):
			continue
		var place: Transform3D = place_of(block, p_level)
		for name: StringName in block.get_parts():
			var part: SurfacePart = _part_of(by_key, p_level, block, place.origin, name)
			part.mesh.set_place(place)
			block.build(part.mesh, name)
	var parts: Array[SurfacePart] = []
	for part: SurfacePart in by_key.values():
		if part.mesh.get_vertex_count() > 0:
			parts.append(part)
	return parts


## The lamps of all blocks below a level's root, in the level's frame.
static func gather_lamps(p_level: Node3D) -> Array[LampLight]:
	var lamps: Array[LampLight] = []
	for node: Node in p_level.find_children("*", "StaticBody3D", true, false):
		var block: KitBlock = node as KitBlock
		if block != null:
			for lamp: LampLight in block.get_lamps():
				lamps.append(lamp.moved(place_of(block, p_level)))
	return lamps


## Where a node below a level's root stands, in the level's frame; they need not be in the tree.
static func place_of(p_node: Node3D, p_level: Node3D) -> Transform3D:
	var place: Transform3D = p_node.transform
	var above: Node = p_node.get_parent()
	while above != null and above != p_level:
		if above is Node3D:
			place = (above as Node3D).transform * place
		above = above.get_parent()
	return place


static func _is_shown(p_node: Node3D, p_level: Node3D) -> bool:
	var node: Node = p_node
	while node != null and node != p_level:
		if node is Node3D and not (node as Node3D).visible:
			return false
		node = node.get_parent()
	return true


static func _part_of(
	p_by_key: Dictionary[String, SurfacePart],
	p_level: Node3D,
	p_block: KitBlock,
	p_place: Vector3,
	p_name: StringName
) -> SurfacePart:
	var key: String = ""
	if p_block.stands_alone() and p_name != KitBlock.ROOF:
		key = "%s/%s" % [p_level.get_path_to(p_block), p_name]
	else:
		var square: Vector3i = Vector3i((p_place / SQUARE_M).floor())
		key = "square %d %d %s" % [square.x, square.z, p_name]
	key = key.left(MAX_KEY)
	if not p_by_key.has(key):
		var part: SurfacePart = SurfacePart.new()
		part.key = key
		part.mesh = KitBlock.make_mesh(false)
		p_by_key[key] = part
	return p_by_key[key]
