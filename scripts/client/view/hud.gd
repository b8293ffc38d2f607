class_name Hud
extends CanvasLayer
## A line of stats, what the screen adds, a line of keys, in the middle what the user must know, and
## the latencies.

@export var _status: Label
@export var _screen: Label
@export var _keys: Label
@export var _message: Label
@export var _guide: Label
@export var _note: Label
@export var _prompt: Label
@export var _tether: Label
@export var _news: UiToasts
@export var _latency: LatencyPanel

# By topic.
var _notes: Dictionary[StringName, String] = {}


## Shows the stats, and the worlds and keys.
func show_status(p_status: String, p_keys: String) -> void:
	_status.text = p_status
	_keys.text = p_keys


## Says what the screen adds to the delays that the stats have.
func show_screen(p_text: String) -> void:
	_screen.text = p_text


## Shows a message in the middle, or none if the text is empty.
func show_message(p_text: String) -> void:
	_message.text = p_text
	_message.visible = p_text != ""


## Tells the wearer what to do or what is wrong with the suit, above the middle; nothing if empty.
func show_guide(p_text: String) -> void:
	_guide.text = p_text
	_guide.visible = p_text != ""


## Shows a note below the stats until another one of its topic comes; none if the text is empty.
func show_note(p_text: String, p_topic: StringName) -> void:
	_notes[p_topic] = p_text
	if p_text == "":
		_notes.erase(p_topic)
	_note.text = "\n".join(_notes.values())
	_note.visible = not _notes.is_empty()


## Shows what has happened, for a while.
func show_news(p_text: String) -> void:
	_news.show_note(p_text)


## Shows what the key for using would do; nothing if the text is empty.
func show_prompt(p_text: String) -> void:
	_prompt.text = "E   " + p_text
	_prompt.visible = p_text != ""


## Tells wearers how far the own body is from their motion; nothing if empty.
func show_tether(p_text: String) -> void:
	_tether.text = p_text
	_tether.visible = p_text != ""


## Sets the latencies that the panel shows, which a key opens.
func show_probe(p_probe: LatencyProbe) -> void:
	_latency.probe = p_probe
