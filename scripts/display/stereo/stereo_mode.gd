class_name StereoMode
extends RefCounted
## How a stereo display wants both eyes' pictures: where each is, and how they are mixed.

## The modes, in the order of [constant NAMES].
enum Kind {
	## One picture for both eyes.
	MONO,
	## Halves of the window beside one another, each squeezed to half its width.
	SIDE_BY_SIDE,
	## Beside one another in full width: the window is twice as wide as what an eye sees.
	SIDE_BY_SIDE_FULL,
	## Halves one above the other, the left eye's on top, each squeezed to half its height.
	TOP_BOTTOM,
	## One above the other in full height.
	TOP_BOTTOM_FULL,
	## Red and cyan glasses.
	ANAGLYPH,
	## Row by row of the panel.
	ROWS,
	## Column by column.
	COLUMNS,
	## By the squares of a checkerboard of pixels.
	CHECKERBOARD,
	## The left eye alone: one station for each eye.
	LEFT,
	## The right eye alone.
	RIGHT,
}

## What layout files call them, and [constant DisplayNames.STEREO] some.
const NAMES: Array[String] = [
	"mono",
	"side-by-side",
	"side-by-side-full",
	"top-bottom",
	"top-bottom-full",
	"anaglyph",
	"rows",
	"columns",
	"checkerboard",
	"left",
	"right",
]


## The mode of a name, or -1.
static func find(p_name: String) -> int:
	return NAMES.find(p_name)


## Into how many parts each axis of a window is cut.
static func parts(p_kind: Kind) -> Vector2i:
	match p_kind:
		Kind.SIDE_BY_SIDE, Kind.SIDE_BY_SIDE_FULL:
			return Vector2i(2, 1)
		Kind.TOP_BOTTOM, Kind.TOP_BOTTOM_FULL:
			return Vector2i(1, 2)
	return Vector2i.ONE


## Whether the parts are squeezed: the display stretches each to its whole size.
static func is_squeezed(p_kind: Kind) -> bool:
	return p_kind == Kind.SIDE_BY_SIDE or p_kind == Kind.TOP_BOTTOM


## How an [EyePicture] mixes the eyes.
static func mix(p_kind: Kind) -> EyePicture.Mix:
	match p_kind:
		Kind.ANAGLYPH:
			return EyePicture.Mix.ANAGLYPH
		Kind.ROWS:
			return EyePicture.Mix.ROWS
		Kind.COLUMNS:
			return EyePicture.Mix.COLUMNS
		Kind.CHECKERBOARD:
			return EyePicture.Mix.CHECKERBOARD
	return EyePicture.Mix.LEFT


## The eyes that are drawn: 0 left, 1 right, -1 between them.
static func eyes(p_kind: Kind) -> PackedInt32Array:
	match p_kind:
		Kind.MONO:
			return [-1]
		Kind.LEFT:
			return [0]
		Kind.RIGHT:
			return [1]
	return [0, 1]


## Pixels of each part of a window, from the left or the top.
static func frames(p_kind: Kind, p_window: Vector2i) -> Array[Rect2i]:
	var cut: Vector2i = parts(p_kind)
	var size: Vector2i = p_window / cut
	var found: Array[Rect2i] = [Rect2i(Vector2i.ZERO, size)]
	if cut != Vector2i.ONE:
		found.append(Rect2i(Vector2i(size.x * (cut.x - 1), size.y * (cut.y - 1)), size))
	return found


## Pixels with which an eye's picture is drawn for a window: of the shape that is seen. A squeezed
## picture is drawn whole, and two pixels become one.
static func eye_size(p_kind: Kind, p_window: Vector2i) -> Vector2i:
	var size: Vector2i = p_window / parts(p_kind)
	return size * parts(p_kind) if is_squeezed(p_kind) else size
