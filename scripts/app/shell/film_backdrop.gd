class_name FilmBackdrop
extends TextureRect
## The living world behind the start screen: a film of the town, over and over.
##
## A film costs a processor less than the world itself would, and is there at once.

## The film; [code]tools/assets/backdrop[/code] makes it.
const FILM: String = "res://assets/ui/backdrop.ogv"

var _player: VideoStreamPlayer = VideoStreamPlayer.new()


func _init() -> void:
	set_anchors_preset(Control.PRESET_FULL_RECT)
	expand_mode = TextureRect.EXPAND_IGNORE_SIZE
	stretch_mode = TextureRect.STRETCH_KEEP_ASPECT_COVERED
	mouse_filter = Control.MOUSE_FILTER_IGNORE
	# Its picture is shown here, cut to the window's shape; the player itself would distort it.
	_player.visible = false
	_player.loop = true
	_player.volume_db = -80.0
	add_child(_player)


func _ready() -> void:
	if not ResourceLoader.exists(FILM):
		return
	_player.stream = load(FILM)
	_player.play()
	texture = _player.get_video_texture()
