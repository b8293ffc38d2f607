class_name LatencyReader
extends RefCounted
## Reads what a [LatencyFile] wrote.


## The delays of a file, or null if it cannot be read. Lines that make no sense are left out.
static func read(p_path: String) -> LatencyProbe:
	var file: FileAccess = FileAccess.open(p_path, FileAccess.READ)
	if file == null:
		return null
	if file.get_csv_line() != PackedStringArray(LatencyMark.COLUMNS):
		return null
	var probe: LatencyProbe = LatencyProbe.new()
	while not file.eof_reached():
		var mark: LatencyMark = _parse(file.get_csv_line())
		if mark != null:
			probe.arrived(mark)
			probe.shows(mark.tick)
			probe.drawn(mark.displayed_usec)
	return probe


static func _parse(p_line: PackedStringArray) -> LatencyMark:
	if p_line.size() != LatencyMark.COLUMNS.size():
		return null
	var mark: LatencyMark = LatencyMark.new()
	# All but the total, which follows from the rest, are whole numbers.
	for column: int in p_line.size() - 1:
		var cell: String = p_line[column]
		if cell.is_valid_int():
			mark.set(LatencyMark.COLUMNS[column], cell.to_int())
		elif cell != "":
			return null
	return mark
