extends TestCase
## The window's title and scale.


func test_titles_name_role_person_and_server() -> void:
	equal(
		WindowFrame.title("trainee", "Ada", "127.0.0.1:7777"),
		"Dismount - trainee Ada - 127.0.0.1:7777"
	)
	equal(WindowFrame.title("observer", "", "10.0.0.5:7800"), "Dismount - observer - 10.0.0.5:7800")
	equal(WindowFrame.title("observer", "observer", "a:1"), "Dismount - observer - a:1")
	equal(WindowFrame.title("replay", "", "session.rec"), "Dismount - replay - session.rec")


func test_texts_grow_with_the_window() -> void:
	almost_equal(WindowFrame.scale_for(Vector2(1280, 720), 96.0), 1.0)
	almost_equal(WindowFrame.scale_for(Vector2(1920, 1080), 96.0), 1.5)
	almost_equal(WindowFrame.scale_for(Vector2(3840, 2160), 96.0), 3.0)
	almost_equal(WindowFrame.scale_for(Vector2(2560, 720), 96.0), 1.0, 1e-4, "it must fit")


func test_texts_of_small_and_huge_windows_stay_legible() -> void:
	almost_equal(WindowFrame.scale_for(Vector2(320, 180), 96.0), 0.75)
	almost_equal(WindowFrame.scale_for(Vector2(0, 0), 96.0), 0.75)
	almost_equal(WindowFrame.scale_for(Vector2(15360, 8640), 96.0), 4.0)


func test_texts_grow_with_the_density_of_the_screen_as_far_as_they_fit() -> void:
	almost_equal(WindowFrame.scale_for(Vector2(1280, 720), 120.0), 1.25)
	almost_equal(WindowFrame.scale_for(Vector2(1280, 720), 300.0), 1.5)
	almost_equal(WindowFrame.scale_for(Vector2(3840, 2160), 192.0), 3.0)


func test_texts_follow_the_window_while_a_node_wants_it_alone() -> void:
	var window: Window = Window.new()
	var node: Node = Node.new()
	window.size = Vector2i(1280, 720)
	window.add_child(node)
	add_child(window)
	WindowFrame.follow(node)
	window.size = Vector2i(2560, 1440)
	await process_frames(1)
	almost_equal(window.content_scale_factor, 2.0)
	node.free()
	window.size = Vector2i(1280, 720)
	await process_frames(1)
	almost_equal(window.content_scale_factor, 2.0, 1e-4, "nobody wants it any more")
	window.free()
