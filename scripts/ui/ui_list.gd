class_name UiList
extends Tree
## A table: titled columns, a row each for what is listed. Up and down go through the rows, Enter
## activates one ([signal Tree.item_activated]).


## Sets the columns: their titles and least widths, px, and the one that takes what is left.
func set_titles(p_titles: PackedStringArray, p_widths: PackedInt32Array, p_wide: int) -> void:
	columns = p_titles.size()
	column_titles_visible = true
	hide_root = true
	select_mode = Tree.SELECT_ROW
	for column: int in columns:
		set_column_title(column, p_titles[column])
		set_column_title_alignment(column, HORIZONTAL_ALIGNMENT_LEFT)
		set_column_custom_minimum_width(column, p_widths[column])
		set_column_expand(column, column == p_wide)
		set_column_clip_content(column, true)


## Takes all rows away.
func clear_rows() -> void:
	clear()
	create_item()


## Adds a row of texts; those of a column are wrapped if asked for.
func add_row(p_texts: PackedStringArray, p_wrapped: int = -1) -> TreeItem:
	var row: TreeItem = create_item(get_root())
	for column: int in p_texts.size():
		row.set_text(column, p_texts[column])
	if p_wrapped >= 0:
		row.set_autowrap_mode(p_wrapped, TextServer.AUTOWRAP_WORD_SMART)
	return row
