class_name UiWords
extends Label
## Large words that are read from a few metres away, in a part of a view, wrapped.


## Words between two corners, as shares of the view.
func _init(p_from: Vector2, p_to: Vector2) -> void:
	anchor_left = p_from.x
	anchor_top = p_from.y
	anchor_right = p_to.x
	anchor_bottom = p_to.y
	autowrap_mode = TextServer.AUTOWRAP_WORD_SMART
