extends SceneTree
## Prints what a file of heights has, as a JSON object: lowest and highest point, m, how many points
## are road, and heights at places. After [code]--[/code]: the file, then X,Z of places.


func _initialize() -> void:
	var arguments: PackedStringArray = OS.get_cmdline_user_args()
	var file: HeightFile = HeightFile.read(arguments[0])
	if file.error != "":
		printerr(file.error)
		quit(1)
		return
	var road: int = 0
	for point: int in file.field.points():
		road += 1 if file.field.paint[point * 4 + HeightField.Paint.ROAD] > 0 else 0
	var heights: Array[float] = []
	for place: String in arguments.slice(1):
		var at: PackedFloat64Array = place.split_floats(",")
		heights.append(file.field.height_at(at[0], at[1]))
	var told: Dictionary = {"lowest": file.lowest_m, "highest": file.highest_m, "road": road}
	told["heights"] = heights
	print(JSON.stringify(told))
	quit()
