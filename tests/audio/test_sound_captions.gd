extends TestCase
## Captions say what, from where, how far.

var _texts: PackedStringArray = []


func test_sides_are_those_of_the_listener() -> void:
	var ear: Transform3D = Transform3D(Basis(Vector3.UP, PI / 2.0), Vector3(5.0, 0.0, 0.0))
	# Turned to the left it looks along -X.
	equal(_side(Vector3(-20.0, 0.0, 0.0), ear), "ahead")
	equal(_side(Vector3(5.0, 0.0, -20.0), ear), "right")
	equal(_side(Vector3(5.0, 0.0, 20.0), ear), "left")
	equal(_side(Vector3(40.0, 0.0, 0.0), ear), "behind")


func test_the_same_is_not_said_again_at_once() -> void:
	var captions: SoundCaptions = SoundCaptions.new()
	captions.shown.connect(_on_shown)
	for number: int in 5:
		captions.take("Gun fires", Vector3(0.0, 0.0, -120.0), -10.0, Transform3D.IDENTITY)
	captions.take("Gun fires", Vector3(90.0, 0.0, 0.0), -10.0, Transform3D.IDENTITY)
	captions.take("Explosion", Vector3(0.0, 0.0, -120.0), -70.0, Transform3D.IDENTITY)
	equal(Array(_texts), ["Gun fires, ahead, 120 m", "Gun fires, right, 90 m"])


static func _side(p_place: Vector3, p_ear: Transform3D) -> String:
	return SoundCaptions.side_of(SoundCaptions.bearing_of(p_place, p_ear))


func _on_shown(p_text: String, _bearing: float) -> void:
	_texts.append(p_text)
