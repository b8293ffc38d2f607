class_name ContactEffectiveMass
extends RefCounted
## How heavy an arm is for what its hand hits.
##
## The effective mass of a hinged chain at a point and in a direction n is m = 1 / (n^T W n) with
## the mobility W = J A^-1 J^T of that point (O. Khatib, "A unified approach for motion and force
## control of robot manipulators: the operational space formulation", IEEE Journal of Robotics and
## Automation 3(1), 1987). Here it is computed in maximal coordinates, which gives the same: masses
## and moments of inertia of the bodies, ball joints at shoulder, elbow and wrist, the shoulder
## fixed in the world, an impulse of 1 N s at the hand's centre; m = 1 / (the speed that the hand
## gets along n). No muscle acts.

const _ARM: Array[String] = ["UpperArm", "LowerArm", "Hand"]


## Effective mass of an arm ("Left" or "Right"), kg, with the bodies at given places, for a blow
## with the hand's centre in a direction.
static func of_arm(
	p_person: ContactPerson, p_bodies: Array[Transform3D], p_side: String, p_direction: Vector3
) -> float:
	var limbs: PackedInt32Array = PackedInt32Array()
	for part: String in _ARM:
		limbs.append(p_person.find(StringName(p_side + part)))
	var unknowns: int = limbs.size() * 6
	var size: int = unknowns + limbs.size() * 3
	var rows: Array[PackedFloat64Array] = []
	for row: int in size:
		var numbers: PackedFloat64Array = PackedFloat64Array()
		numbers.resize(size + 1)
		rows.append(numbers)
	for i: int in limbs.size():
		_add_body(rows, i * 6, p_person, limbs[i], p_bodies[limbs[i]].basis)
		var joint: Vector3 = p_person.joint(limbs[i], p_bodies)
		var at: int = unknowns + i * 3
		_add_joint(rows, at, i * 6, joint - p_bodies[limbs[i]].origin, 1.0)
		if i > 0:
			_add_joint(rows, at, (i - 1) * 6, joint - p_bodies[limbs[i - 1]].origin, -1.0)
	var hand: int = (limbs.size() - 1) * 6
	for axis: int in 3:
		rows[hand + axis][size] = p_direction[axis]
	var solution: PackedFloat64Array = _solve(rows)
	var gained: Vector3 = Vector3(solution[hand], solution[hand + 1], solution[hand + 2])
	return 1.0 / gained.dot(p_direction)


## Mass and moments of inertia, in the world's axes.
static func _add_body(
	p_rows: Array[PackedFloat64Array],
	p_at: int,
	p_person: ContactPerson,
	p_limb: int,
	p_axes: Basis
) -> void:
	var own: Vector3 = p_person.inertia_of(p_limb)
	var inertia: Basis = p_axes * Basis.from_scale(own) * p_axes.transposed()
	for row: int in 3:
		p_rows[p_at + row][p_at + row] = p_person.mass_of(p_limb)
		for column: int in 3:
			p_rows[p_at + 3 + row][p_at + 3 + column] = inertia[column][row]


## The velocity v + w x r of a body's point, which a joint makes equal to that of the other body;
## and the joint's impulse on the body.
static func _add_joint(
	p_rows: Array[PackedFloat64Array], p_at: int, p_body: int, p_arm: Vector3, p_sign: float
) -> void:
	for axis: int in 3:
		var unit: Vector3 = Vector3.ZERO
		unit[axis] = p_sign
		var turn: Vector3 = p_arm.cross(unit)
		for part: int in 3:
			for pair: Array in [[part, unit[part]], [part + 3, turn[part]]]:
				var column: int = p_body + (pair[0] as int)
				p_rows[p_at + axis][column] = pair[1]
				p_rows[column][p_at + axis] = pair[1]


## Gauss's elimination with pivoting; the last number of each row is the right side.
static func _solve(p_rows: Array[PackedFloat64Array]) -> PackedFloat64Array:
	var size: int = p_rows.size()
	for step: int in size:
		var best: int = step
		for row: int in range(step + 1, size):
			if absf(p_rows[row][step]) > absf(p_rows[best][step]):
				best = row
		var pivot: PackedFloat64Array = p_rows[best]
		p_rows[best] = p_rows[step]
		p_rows[step] = pivot
		for row: int in range(step + 1, size):
			var factor: float = p_rows[row][step] / pivot[step]
			if factor != 0.0:
				for column: int in range(step, size + 1):
					p_rows[row][column] -= factor * pivot[column]
	var solution: PackedFloat64Array = PackedFloat64Array()
	solution.resize(size)
	for row: int in range(size - 1, -1, -1):
		var sum: float = p_rows[row][size]
		for column: int in range(row + 1, size):
			sum -= p_rows[row][column] * solution[column]
		solution[row] = sum / p_rows[row][row]
	return solution
