class_name SourceFrames
extends RefCounted
## Converts motion sources' values to Godot's frame: axes are exchanged only here.
##
## Godot's frame here: right-handed, Y up, metres; somebody who faces the source's own "forward"
## (Xsens: the magnetic north) faces +Z, as the reset pose of [Limbs] does, with the left to +X.
## All maps but Unity's are proper rotations, so that a quaternion keeps its w.

## Frames that sources speak.
enum Frame {
	## Xsens' own: X north, Y west, Z up, right-handed. MVN's types 02, 13, 20 to 24 too (X forward,
	## Y left, Z up, metres).
	XSENS,
	## Xsens with the output setting NED: X north, Y east, Z down.
	XSENS_NED,
	## MTData2's ENU: X east, Y north, Z up.
	XSENS_ENU,
	## MVN's type 01: Y up, right-handed, positions in cm. Z is forward, X left.
	MVN_Y_UP,
	## MVN's type 05: Unity's left-handed frame, Y up, Z forward, X right, metres.
	MVN_UNITY,
	## BVH files with Z up: X stays, Y goes to the back; the file's units.
	BVH_Z_UP,
	## BVH files with X up: Z stays, Y goes to the right.
	BVH_X_UP,
	## BVH files with Y down, as cameras have it: X stays, Z goes to the back.
	BVH_Y_DOWN,
	## BVH files with Z down: X stays, Y goes to the front.
	BVH_Z_DOWN,
	## BVH files with X down: Z stays, Y goes to the left.
	BVH_X_DOWN,
	## Godot's own.
	GODOT,
}

const _HALF: float = 0.7071067811865476


## A rotation from w, x, y, z of the source's frame. The result goes from the sensor's (or
## segment's) axes, exchanged like the frame's, to Godot's frame. Sensors' own axes are X, Y and Z
## up in all of Xsens' frames, so changing the reference does not change a sensor's mounting.
static func rotation(
	p_w: float, p_x: float, p_y: float, p_z: float, p_frame: Frame = Frame.XSENS
) -> Quaternion:
	match p_frame:
		Frame.XSENS:
			return Quaternion(p_y, p_z, p_x, p_w)
		Frame.XSENS_NED:
			# Half a turn about the north first: i * q.
			return Quaternion(-p_z, p_y, p_w, -p_x)
		Frame.XSENS_ENU:
			# A quarter of a turn about the vertical first: (1 - k) * q / sqrt 2.
			return Quaternion(p_y - p_x, p_z - p_w, p_x + p_y, p_w + p_z) * _HALF
		Frame.MVN_UNITY:
			return Quaternion(p_x, -p_y, -p_z, p_w)
		Frame.BVH_Z_UP:
			return Quaternion(p_x, p_z, -p_y, p_w)
		Frame.BVH_X_UP:
			return Quaternion(-p_y, p_x, p_z, p_w)
		Frame.BVH_Y_DOWN:
			return Quaternion(p_x, -p_y, -p_z, p_w)
		Frame.BVH_Z_DOWN:
			return Quaternion(p_x, -p_z, p_y, p_w)
		Frame.BVH_X_DOWN:
			return Quaternion(p_y, -p_x, p_z, p_w)
	return Quaternion(p_x, p_y, p_z, p_w)


## A direction, or a rate or an acceleration in a sensor's own axes; [param p_frame] is the one in
## which its orientation comes. Units stay.
static func vector(p_vector: Vector3, p_frame: Frame = Frame.XSENS) -> Vector3:
	match p_frame:
		Frame.XSENS:
			return Vector3(p_vector.y, p_vector.z, p_vector.x)
		Frame.XSENS_NED:
			return Vector3(-p_vector.y, -p_vector.z, p_vector.x)
		Frame.XSENS_ENU:
			return Vector3(-p_vector.x, p_vector.z, p_vector.y)
		Frame.MVN_UNITY:
			return Vector3(-p_vector.x, p_vector.y, p_vector.z)
		Frame.BVH_Z_UP:
			return Vector3(p_vector.x, p_vector.z, -p_vector.y)
		Frame.BVH_X_UP:
			return Vector3(-p_vector.y, p_vector.x, p_vector.z)
		Frame.BVH_Y_DOWN:
			return Vector3(p_vector.x, -p_vector.y, -p_vector.z)
		Frame.BVH_Z_DOWN:
			return Vector3(p_vector.x, -p_vector.z, p_vector.y)
		Frame.BVH_X_DOWN:
			return Vector3(p_vector.y, -p_vector.x, p_vector.z)
	return p_vector


## A rate (rad/s) or an acceleration in the sensor's own axes: in all of Xsens' frames the same map
## as [method rotation] has for those axes.
static func sensor_vector(p_vector: Vector3) -> Vector3:
	return Vector3(p_vector.y, p_vector.z, p_vector.x)


## A position of the source, m in Godot's frame.
static func position(p_position: Vector3, p_frame: Frame = Frame.XSENS) -> Vector3:
	var scale: float = 0.01 if p_frame == Frame.MVN_Y_UP else 1.0
	return vector(p_position, p_frame) * scale


## The rotation of Euler angles of MVN's type 01, degrees, as MotionBuilder and Maya have them:
## about X first, then about the old Y, then about the old Z.
static func rotation_from_euler(p_degrees: Vector3) -> Quaternion:
	return (
		Quaternion(Vector3.BACK, deg_to_rad(p_degrees.z))
		* Quaternion(Vector3.UP, deg_to_rad(p_degrees.y))
		* Quaternion(Vector3.RIGHT, deg_to_rad(p_degrees.x))
	)


## Many rotations at once: w, x, y, z each from the source; x, y, z, w each to Godot.
static func rotations(
	p_wxyz: PackedFloat32Array, p_frame: Frame = Frame.XSENS
) -> PackedFloat32Array:
	var found: PackedFloat32Array = PackedFloat32Array()
	found.resize(p_wxyz.size() - p_wxyz.size() % 4)
	for at: int in range(0, found.size(), 4):
		if p_frame == Frame.XSENS:
			found[at] = p_wxyz[at + 2]
			found[at + 1] = p_wxyz[at + 3]
			found[at + 2] = p_wxyz[at + 1]
			found[at + 3] = p_wxyz[at]
			continue
		var turned: Quaternion = rotation(
			p_wxyz[at], p_wxyz[at + 1], p_wxyz[at + 2], p_wxyz[at + 3], p_frame
		)
		found[at] = turned.x
		found[at + 1] = turned.y
		found[at + 2] = turned.z
		found[at + 3] = turned.w
	return found


## Many rates or accelerations in sensors' axes at once.
static func sensor_vectors(p_vectors: PackedVector3Array) -> PackedVector3Array:
	var found: PackedVector3Array = p_vectors.duplicate()
	for at: int in found.size():
		found[at] = sensor_vector(found[at])
	return found


## Many positions at once, m in Godot's frame.
static func positions(
	p_positions: PackedVector3Array, p_frame: Frame = Frame.XSENS
) -> PackedVector3Array:
	var found: PackedVector3Array = p_positions.duplicate()
	for at: int in found.size():
		found[at] = position(found[at], p_frame)
	return found
