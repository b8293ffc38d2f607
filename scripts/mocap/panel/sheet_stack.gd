class_name SheetStack
extends RefCounted
## The sheets of a panel, of which one is open at a time. One that was opened from another gives its
## place back to it.

## Another one is open, or none.
signal changed

var _sheets: Array[PanelSheet] = []
# What comes back when the open one closes, or null.
var _below: PanelSheet = null


## Takes the sheets, and closes them.
func _init(p_sheets: Array[PanelSheet]) -> void:
	_sheets = p_sheets
	for sheet: PanelSheet in _sheets:
		sheet.visible = false
		sheet.close_wanted.connect(toggle.bind(sheet))


## The one that is open, or null.
func current() -> PanelSheet:
	for sheet: PanelSheet in _sheets:
		if sheet.visible:
			return sheet
	return null


## Opens a sheet instead of the one that is open, or closes it.
func toggle(p_sheet: PanelSheet) -> void:
	if current() == p_sheet:
		_show(_below)
	else:
		_show(p_sheet)


## Opens a sheet over the one that is open.
func open_above(p_sheet: PanelSheet) -> void:
	var before: PanelSheet = current()
	_show(p_sheet)
	_below = before


func _show(p_sheet: PanelSheet) -> void:
	_below = null
	for sheet: PanelSheet in _sheets:
		sheet.visible = sheet == p_sheet
	changed.emit()
	if p_sheet != null:
		p_sheet.focus_first()
