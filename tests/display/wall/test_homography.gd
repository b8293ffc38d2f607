extends TestCase
## Dragged corners of a projector's picture.


func test_corners_go_where_they_were_dragged_and_lines_stay_straight() -> void:
	var corners: PackedVector2Array = [
		Vector2(0.1, 0.05), Vector2(0.95, 0.0), Vector2(1.0, 0.9), Vector2(0.0, 1.0)
	]
	var map: Basis = Homography.to_corners(corners)
	var square: PackedVector2Array = [Vector2.ZERO, Vector2.RIGHT, Vector2.ONE, Vector2.DOWN]
	for at: int in 4:
		almost_equal(Homography.apply(map, square[at]), corners[at], 1e-5)
		var back: Vector2 = Homography.apply(map.inverse(), corners[at])
		almost_equal(back, square[at], 1e-5)
	var middle: Vector2 = Homography.apply(map, Vector2(0.5, 0.5))
	var crossing: Variant = Geometry2D.segment_intersects_segment(
		corners[0], corners[2], corners[1], corners[3]
	)
	almost_equal(middle, crossing as Vector2, 1e-5, "diagonals meet in the middle")


func test_crossed_mirrored_and_flat_corners_are_no_picture() -> void:
	var good: PackedVector2Array = [Vector2.ZERO, Vector2.RIGHT, Vector2.ONE, Vector2.DOWN]
	is_true(Homography.is_convex(good))
	is_false(Homography.is_convex([good[1], good[0], good[3], good[2]]), "mirrored")
	is_false(Homography.is_convex([good[0], good[2], good[1], good[3]]), "crossed")
	is_false(Homography.is_convex([good[0], good[1], Vector2(2, 0), Vector2(3, 0)]), "flat")
