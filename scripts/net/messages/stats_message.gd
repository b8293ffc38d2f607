class_name StatsMessage
extends RefCounted
## A client's own stats, sent to its server once a second for the server's status.
##
## Little-endian: u8 message, u16 median and u16 95th percentile of the delay from sample to
## display, u16 how far what is shown is behind the quickest arrivals (0.1 ms; 65535 or more is
## 65535), u16 frames per second.

## Size of the packet, bytes.
const SIZE: int = 9
## Seconds from one to the next.
const PERIOD_S: float = 1.0

const _UNIT_MS: float = 0.1
const _MAX: int = 65535


## The bytes of stats: ms, ms, ms, frames per second.
static func encode(
	p_median_ms: float, p_high_ms: float, p_behind_ms: float, p_frames: float
) -> PackedByteArray:
	var bytes: PackedByteArray = PackedByteArray()
	bytes.resize(SIZE)
	bytes.encode_u8(0, Protocol.Message.STATS)
	var at: int = 1
	for number: float in [
		p_median_ms / _UNIT_MS, p_high_ms / _UNIT_MS, p_behind_ms / _UNIT_MS, p_frames
	]:
		bytes.encode_u16(at, clampi(roundi(number), 0, _MAX) if is_finite(number) else 0)
		at += 2
	return bytes


## The stats by the names that a status has, or an empty dictionary if it is no such packet.
static func decode(p_bytes: PackedByteArray) -> Dictionary:
	if p_bytes.size() != SIZE or p_bytes[0] != Protocol.Message.STATS:
		return {}
	return {
		"display_latency_ms_p50": p_bytes.decode_u16(1) * _UNIT_MS,
		"display_latency_ms_p95": p_bytes.decode_u16(3) * _UNIT_MS,
		"smoothing_delay_ms": p_bytes.decode_u16(5) * _UNIT_MS,
		"frames_per_second": p_bytes.decode_u16(7),
	}
