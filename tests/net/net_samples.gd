extends RefCounted
## Random packets' contents for the tests of the wire, and damage to packets.

## Characters of random texts, of one to four bytes.
const LETTERS: String = "aZ_ /.:Größe東京😀"


## A pose that is valid.
static func pose(p_random: RandomNumberGenerator) -> PoseSample:
	var sample: PoseSample = PoseSample.new()
	sample.id = p_random.randi()
	sample.time_usec = p_random.randi() * p_random.randi_range(0, 1000000)
	sample.root = vector(p_random, 100.0)
	for limb: int in Limbs.COUNT:
		sample.set_orientation(limb, rotation(p_random))
	return sample


## A sample's datagram, coded against nothing.
static func motion(p_sample: PoseSample) -> PackedByteArray:
	return SampleWriter.new().write([p_sample] as Array[PoseSample])[0]


## A table of so many bodies and people.
static func table(p_random: RandomNumberGenerator, p_bodies: int, p_people: int) -> EntityTable:
	var made: EntityTable = EntityTable.new()
	var prop: EntityType = EntityType.new()
	prop.name = &"prop"
	prop.body = EntityType.Body.RIGID
	for _person: int in p_people:
		var row: EntityRow = EntityRow.new()
		row.type = EntityType.person()
		row.owner = p_random.randi_range(0, 1000)
		row.person_name = text(p_random)
		row.skeleton = skeleton(p_random)
		made.spawn(row)
	for _body: int in p_bodies:
		var row: EntityRow = EntityRow.new()
		row.type = prop
		row.source = EntityRow.Source.LEVEL
		row.path = text(p_random)
		made.spawn(row)
	return made


## The message that tells of a table of so many bodies and people.
static func table_bytes(
	p_random: RandomNumberGenerator, p_bodies: int, p_people: int
) -> PackedByteArray:
	return EntityTableMessage.of_table(table(p_random, p_bodies, p_people), 0.1).encode()


## A skeleton that can be somebody's; now and then none.
static func skeleton(p_random: RandomNumberGenerator) -> PersonSkeleton:
	var made: PersonSkeleton = PersonSkeleton.new()
	if p_random.randf() < 0.2:
		return made
	for limb: int in Limbs.COUNT:
		made.add(vector(p_random, 0.3), vector(p_random, 0.3), rotation(p_random))
	return made


## A rotation, all equally likely.
static func rotation(p_random: RandomNumberGenerator) -> Quaternion:
	var turn: Quaternion = Quaternion(
		p_random.randfn(), p_random.randfn(), p_random.randfn(), p_random.randfn()
	)
	return turn.normalized()


## A vector within a cube.
static func vector(p_random: RandomNumberGenerator, p_most: float) -> Vector3:
	return Vector3(
		p_random.randf_range(-p_most, p_most),
		p_random.randf_range(-p_most, p_most),
		p_random.randf_range(-p_most, p_most)
	)


## A rigid transform.
static func transform(p_random: RandomNumberGenerator) -> Transform3D:
	return Transform3D(Basis(rotation(p_random)), vector(p_random, 500.0))


## A text of up to 30 characters.
static func text(p_random: RandomNumberGenerator) -> String:
	var made: String = ""
	for _letter: int in p_random.randi_range(0, 30):
		made += LETTERS[p_random.randi_range(0, LETTERS.length() - 1)]
	return made


## A packet with some damage: bytes changed, cut off, added or moved.
static func damage(p_random: RandomNumberGenerator, p_bytes: PackedByteArray) -> PackedByteArray:
	var bytes: PackedByteArray = p_bytes.duplicate()
	for _time: int in p_random.randi_range(1, 4):
		var at: int = p_random.randi_range(0, maxi(bytes.size() - 1, 0))
		match p_random.randi_range(0, 5):
			0, 1:
				if not bytes.is_empty():
					bytes[at] = p_random.randi_range(0, 255)
			2:
				if not bytes.is_empty():
					bytes[at] = bytes[at] ^ (1 << p_random.randi_range(0, 7))
			3:
				bytes.resize(at)
			4:
				bytes.append_array(noise(p_random, 20))
			5:
				# A number that is not finite, or as large as can be.
				for byte: int in range(at, mini(at + 4, bytes.size())):
					bytes[byte] = 0xFF
	return bytes


## Random bytes, not more than so many; mostly a message's kind first.
static func noise(p_random: RandomNumberGenerator, p_most: int) -> PackedByteArray:
	var bytes: PackedByteArray = []
	for _byte: int in p_random.randi_range(0, p_most):
		bytes.append(p_random.randi_range(0, 255))
	if not bytes.is_empty() and p_random.randf() < 0.7:
		bytes[0] = p_random.randi_range(0, 4)
	return bytes
