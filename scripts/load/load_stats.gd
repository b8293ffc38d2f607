class_name LoadStats
extends RefCounted
## Counts of one client of a load run, since [method LoadClient.begin_counting].

## Datagrams of snapshots by [enum SnapshotDecoder.Outcome].
var outcomes: PackedInt32Array = PackedInt32Array([0, 0, 0, 0, 0])
## Bytes of these datagrams, without headers.
var bytes: int = 0
## Ages of what is known of each person, sampled evenly in time.
var ages: LatencyHistogram = LatencyHistogram.new()
## Ages that could not be measured, as a person who was there had no known state.
var unknown: int = 0
## From a sample in a suit to its arrival at this client.
var probe: LatencyProbe = LatencyProbe.new()
## Connections that were lost.
var lost: int = 0
## Connections made after these.
var returned: int = 0


## Records the outcome of a datagram.
func took(p_outcome: SnapshotDecoder.Outcome, p_size: int) -> void:
	outcomes[p_outcome] += 1
	bytes += p_size


## Records a sample's latency, which ended with a snapshot at a time of the server's clock, µs.
func marked(p_mark: LatencyMark) -> void:
	probe.arrived(p_mark)
	probe.shows(p_mark.tick)
	probe.drawn(p_mark.arrival_usec)


## The stats for a report.
func report() -> Dictionary:
	var by_name: Dictionary = {}
	var names: PackedStringArray = ["ok", "broken", "stale", "lacks_baseline", "not_begun"]
	for outcome: int in names.size():
		by_name[names[outcome]] = outcomes[outcome]
	return {
		"snapshots": by_name["ok"],
		"outcomes": by_name,
		"bytes": bytes,
		"age": ages.stats(),
		"unknown_ages": unknown,
		"lost": lost,
		"returned": returned,
		"latency": probe.stats(),
	}
