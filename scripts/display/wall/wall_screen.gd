class_name WallScreen
extends RefCounted
## One screen of a station, as its layout file has it.

## Edges, in the order of [member blend].
const EDGES: Array[String] = ["left", "right", "top", "bottom"]

## Its name.
var name: String = ""
## The line of the layout file where it begins.
var line: int = 0
## Lower left corner, in the station's frame, m: x to the right, y up from the floor, -z ahead.
var bottom_left: Vector3 = Vector3.ZERO
## Lower right corner, as the viewer sees it.
var bottom_right: Vector3 = Vector3.ZERO
## Upper left corner.
var top_left: Vector3 = Vector3.ZERO
## The fourth corner, only to be checked; infinite where the file does not have it.
var top_right: Vector3 = Vector3.INF
## The line that has it.
var top_right_line: int = 0
## The number or the name of its monitor; empty where [member size] says where its window is.
var monitor: String = ""
## Where its window is on the desktop, pixels.
var position: Vector2i = Vector2i.ZERO
## How large its window is, pixels.
var size: Vector2i = Vector2i.ZERO
## How it shows both eyes.
var mode: StereoMode.Kind = StereoMode.Kind.MONO
## Whether each eye gets the other one's picture.
var swap_eyes: bool = false
## Where the picture's corners are in the window (0..1, y downwards): top left, top right, bottom
## right, bottom left. Empty: it fills the window.
var warp: PackedVector2Array = []
## A mesh instead of that; null: none.
var mesh: WarpMesh = null
## Widths of the edges that fade, as shares of the picture: left, right, top, bottom.
var blend: Vector4 = Vector4.ZERO
## Of the projector.
var gamma: float = 2.2
## The value (0..1) that is as bright as black is in an overlap, but where only this projector is.
var black_level: float = 0.0


## Whether its window covers a part of another one's, as far as the layout says where both are.
func shares_pixels_with(p_other: WallScreen) -> bool:
	if monitor != "" and monitor == p_other.monitor:
		return true
	return Rect2i(position, size).intersects(Rect2i(p_other.position, p_other.size))


## Its rectangle as an eye sees it, in the station's frame.
func seen_from(p_eye: Vector3) -> OffAxisFrustum:
	return OffAxisFrustum.through(bottom_left, bottom_right, top_left, p_eye)


## Width by height, m/m.
func shape() -> float:
	var frustum: OffAxisFrustum = seen_from(Vector3.ZERO)
	return frustum.extent.x / frustum.extent.y


## Light by which black is raised where nothing overlaps.
func black_lift() -> float:
	return pow(black_level, gamma)


## Pixels with which a picture of a rectangle is drawn for a frame of a window, and the part of the
## picture that the rectangle is: pixels are square, so it may have to be a little wider.
static func picture_for(p_shape: float, p_frame: Vector2i) -> Vector2i:
	# Where the frame has the rectangle's shape to less than a pixel, pixel becomes pixel.
	var wide: int = maxi(p_frame.x, ceili(p_frame.y * p_shape - 1e-3))
	return Vector2i(wide, maxi(floori(wide / p_shape + 1e-3), 1))


## The part of such a picture that the rectangle is.
static func crop_of(p_shape: float, p_picture: Vector2i) -> Rect2:
	var share: float = minf(p_shape * p_picture.y / p_picture.x, 1.0)
	return Rect2(0.5 - 0.5 * share, 0.0, share, 1.0)
