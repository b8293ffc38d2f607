extends Node
## Eight people and two hundred crates that all move, for one client, on several networks.

const MovingWorld: GDScript = preload("moving_world.gd")
const ReplicationCase: GDScript = preload("replication_case.gd")
const GOAL_KILOBITS: float = 256.0
## What the encoder may use: a little less, as it may save up for a moment.
const SHARE_KILOBITS: float = 250.0
const GOAL_CRATE_M: float = 0.02

## Name, snapshots per second, one way s, up to so much more s, share lost.
const NETWORKS: Array[Array] = [
	["LAN, 60 Hz", 60, 0.0005, 0.0, 0.0],
	["LAN, 30 Hz", 30, 0.0005, 0.0, 0.0],
	["25 +- 10 ms, 2 % lost, 60 Hz", 60, 0.015, 0.02, 0.02],
	["25 +- 10 ms, 2 % lost, 30 Hz", 30, 0.015, 0.02, 0.02],
	["25 +- 10 ms, 20 % lost, 30 Hz", 30, 0.015, 0.02, 0.2],
]

## Name, one way s, error in degrees, goal in kbit/s.
const ALONE: Array[Array] = [
	["LAN, 0.1 deg", 0.0005, 0.1, 9.0],
	["25 ms each way, 0.1 deg", 0.025, 0.1, 10.5],
	["LAN, 0.5 deg", 0.0005, 0.5, 5.5],
	["25 ms each way, 0.5 deg", 0.025, 0.5, 7.5],
]


## Runs all cases and adds their stats to a report.
func run(
	p_report: BenchReport, p_sources: Array[BvhSource], p_people: int, p_crates: int, p_s: float
) -> void:
	var people: Array[BvhSource] = []
	for person: int in p_people:
		people.append(p_sources[person % p_sources.size()])
	var world: MovingWorld = MovingWorld.new(people, p_crates)
	add_child(world)
	var cases: Array[ReplicationCase] = []
	for network: Array in NETWORKS:
		cases.append(
			ReplicationCase.new(network[1], SHARE_KILOBITS, network[2], network[3], network[4])
		)
	var seconds: float = await _play(world, cases, p_s)
	var name: String = "%d people, %d crates" % [p_people, p_crates]
	for i: int in cases.size():
		_add(p_report, "%s: %s" % [name, NETWORKS[i][0]], cases[i], seconds)


## One person and nothing else, 30 snapshots a second, as the program sends it: whole datagrams,
## with their headers of ours, marks and all. The mean of the clips.
func run_one(p_report: BenchReport, p_sources: Array[BvhSource], p_s: float) -> void:
	for one: Array in ALONE:
		var bits: float = 0.0
		for source: BvhSource in p_sources:
			var world: MovingWorld = MovingWorld.new([source] as Array[BvhSource], 0)
			add_child(world)
			var client: ReplicationCase = ReplicationCase.new(
				30, SHARE_KILOBITS, one[1], 0.0, 0.0, one[2]
			)
			var rate: int = Engine.physics_ticks_per_second
			for tick: int in int((p_s + 2.0) * rate):
				client.payload_bits = 0 if tick == 2 * rate else client.payload_bits
				client.advance(world)
			bits += client.payload_bits / p_s / p_sources.size()
			world.free()
		var name: String = "whole datagrams of a person, 30 Hz, %s" % one[0]
		p_report.at_most(name, "without headers", bits / 1000.0, "kbit/s", one[3])


func _play(p_world: MovingWorld, p_cases: Array[ReplicationCase], p_s: float) -> float:
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	var begin: int = 2 * Engine.physics_ticks_per_second
	var ticks: int = int(p_s / delta)
	for tick: int in begin + ticks:
		p_world.push(delta)
		await get_tree().physics_frame
		if tick == begin:
			for one: ReplicationCase in p_cases:
				one.bits = 0
		for one: ReplicationCase in p_cases:
			one.advance(p_world)
	return ticks * delta


static func _add(
	p_report: BenchReport, p_name: String, p_case: ReplicationCase, p_s: float
) -> void:
	p_report.at_most(p_name, "with headers", p_case.bits / p_s / 1000.0, "kbit/s", GOAL_KILOBITS)
	var error: float = sqrt(p_case.crate_square / maxf(p_case.crate_count, 1.0))
	p_report.at_most(p_name, "crates as shown, RMS", error * 100.0, "cm", GOAL_CRATE_M * 100.0)
	p_case.encode_usec.sort()
	var middle: float = p_case.encode_usec[p_case.encode_usec.size() / 2]
	p_report.add(p_name, "encode, p50", middle, "us")
