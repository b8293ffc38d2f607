extends TestCase
## With how many pixels a wall is drawn.


func test_a_window_of_the_walls_shape_is_drawn_pixel_by_pixel() -> void:
	equal(WallScreen.picture_for(16.0 / 9.0, Vector2i(640, 360)), Vector2i(640, 360))
	almost_equal(WallScreen.crop_of(16.0 / 9.0, Vector2i(640, 360)).size, Vector2.ONE, 1e-5)


func test_pixels_stay_square_where_the_window_has_another_shape() -> void:
	for shape: float in [0.7, 1.0, 1.31, 2.4]:
		for frame: Vector2i in [Vector2i(640, 360), Vector2i(300, 500), Vector2i(320, 360)]:
			var picture: Vector2i = WallScreen.picture_for(shape, frame)
			is_true(picture.x >= frame.x and picture.y >= frame.y - 1, str(picture))
			var crop: Rect2 = WallScreen.crop_of(shape, picture)
			almost_equal(crop.size.x * picture.x / picture.y, shape, 2e-3)
			almost_equal(crop.get_center(), Vector2(0.5, 0.5), 1e-5)
