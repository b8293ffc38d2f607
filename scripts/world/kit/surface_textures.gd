class_name SurfaceTextures
extends RefCounted
## The pictures of all surfaces as the device wants them.
##
## They are imported compressed (S3TC), which a graphics card reads as they are: a sixth of the
## memory, and no time to load. A processor that draws would unpack each pixel each time it looks at
## it, at half of the frame rate: for it they are unpacked once, no larger than the tier of quality
## says.

## What a file of layers begins with, and its head: 9 numbers of 4 bytes, of which the third is the
## number of layers.
const _MAGIC: String = "GSTL"
const _HEAD: int = 36
## Head of a layer: kind of data, edges, levels, format.
const _LAYER_HEAD: int = 16
const _RAW: int = 0

static var _arrays: Array[CompressedTexture2DArray] = []
static var _edge: int = 0


## Reads them, once for a size. A thread may do it.
static func prepare() -> void:
	if _arrays.is_empty():
		for path: String in [SurfaceLayers.ALBEDO, SurfaceLayers.NORMAL, SurfaceLayers.ORM]:
			_arrays.append(load(path) as CompressedTexture2DArray)
	if _edge == Quality.tier.texture_pixels or not Quality.draws_by_processor():
		return
	_edge = Quality.tier.texture_pixels
	for array: CompressedTexture2DArray in _arrays:
		var images: Array[Image] = unpack(array.load_path, _edge)
		if not images.is_empty():
			# Materials that have the texture see what it holds now.
			var kind: RenderingServer.TextureLayeredType = RenderingServer.TEXTURE_LAYERED_2D_ARRAY
			var fresh: RID = RenderingServer.texture_2d_layered_create(images, kind)
			RenderingServer.texture_replace(array.get_rid(), fresh)


## The layers of an imported file of compressed layers, unpacked, with edges of so many pixels at
## most; none where the file is something else.
static func unpack(p_path: String, p_edge: int) -> Array[Image]:
	var images: Array[Image] = []
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null or file.get_length() < _HEAD:
		return images
	if file.get_buffer(_MAGIC.length()) != _MAGIC.to_ascii_buffer():
		return images
	file.get_32()
	var count: int = file.get_32()
	file.seek(_HEAD)
	for _layer: int in count:
		var image: Image = _read_layer(file, p_edge)
		if image == null:
			return []
		images.append(image)
	return images


static func _read_layer(p_file: FileAccess, p_edge: int) -> Image:
	if p_file.get_position() + _LAYER_HEAD > p_file.get_length() or p_file.get_32() != _RAW:
		return null
	var size: Vector2i = Vector2i(p_file.get_16(), p_file.get_16())
	var levels: int = p_file.get_32()
	var format: int = p_file.get_32()
	if format != Image.FORMAT_DXT1 or levels == 0 or size.x != size.y:
		return null
	# 8 bytes are 4 x 4 pixels; the smallest levels are padded to that.
	var bytes: PackedByteArray = []
	for level: int in levels + 1:
		var edge: int = maxi(size.x >> level, 1)
		var blocks: int = maxi(edge / 4, 1)
		var part: PackedByteArray = p_file.get_buffer(blocks * blocks * 8)
		if edge <= p_edge:
			bytes.append_array(part)
	var shown: int = mini(size.x, p_edge)
	var image: Image = Image.create_from_data(shown, shown, true, Image.FORMAT_DXT1, bytes)
	if image == null or image.decompress() != OK:
		return null
	return image
