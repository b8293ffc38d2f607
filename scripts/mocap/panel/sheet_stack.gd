class_name SheetStack
extends RefCounted
## The sheets of a panel, of which one is open at a time. One that was opened from the widest gives
## its place back to it.

## Another one is open, or none.
signal changed

var _sheets: Array[PanelSheet] = []
var _widest: PanelSheet = null
# What comes back when the open one closes, or null.
var _below: PanelSheet = null


## Takes the sheets and the widest of them, and closes them.
func _init(p_sheets: Array[PanelSheet], p_widest: PanelSheet) -> void:
	_sheets = p_sheets
	_widest = p_widest
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
	var before: PanelSheet = current()
	var opened: PanelSheet = _below if before == p_sheet else p_sheet
	_below = _widest if before == _widest and opened != null else null
	for sheet: PanelSheet in _sheets:
		sheet.visible = sheet == opened
	changed.emit()
	if opened != null:
		opened.focus_first()
