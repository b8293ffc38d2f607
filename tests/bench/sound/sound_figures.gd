extends RefCounted
## Figures of samples: crest, decay, lines, seams.


## Samples of a wave file of 16 bits, 1 is full scale.
static func samples_of(p_stream: AudioStreamWAV) -> PackedFloat32Array:
	var bytes: PackedByteArray = p_stream.data
	var samples: PackedFloat32Array = []
	samples.resize(bytes.size() / 2)
	for index: int in samples.size():
		samples[index] = bytes.decode_s16(index * 2) / 32768.0
	return samples


## Greatest value beside the mean power, dB.
static func crest_db(p_samples: PackedFloat32Array) -> float:
	var peak: float = 0.0
	var sum: float = 0.0
	for value: float in p_samples:
		peak = maxf(peak, absf(value))
		sum += value * value
	return linear_to_db(peak / sqrt(maxf(sum / p_samples.size(), 1e-12)))


## How soon a share of the energy is past, s.
static func energy_time(p_samples: PackedFloat32Array, p_share: float, p_rate: float) -> float:
	var sum: float = 0.0
	for value: float in p_samples:
		sum += value * value
	var part: float = 0.0
	for index: int in p_samples.size():
		part += p_samples[index] * p_samples[index]
		if part >= sum * p_share:
			return index / p_rate
	return p_samples.size() / p_rate


## Power at a frequency (Goertzel), with a window that hides the ends.
static func power_at(p_samples: PackedFloat32Array, p_hz: float, p_rate: float) -> float:
	var turn: float = 2.0 * cos(TAU * p_hz / p_rate)
	var last: float = 0.0
	var before: float = 0.0
	var step: float = TAU / p_samples.size()
	for index: int in p_samples.size():
		var value: float = p_samples[index] * (0.5 - 0.5 * cos(step * index))
		var now: float = value + turn * last - before
		before = last
		last = now
	return last * last + before * before - turn * last * before


## The strongest line between two frequencies, Hz: in steps, then finer.
static func strongest_hz(
	p_samples: PackedFloat32Array, p_from: float, p_to: float, p_step: float, p_rate: float
) -> float:
	var best: float = p_from
	var most: float = -1.0
	var step: float = p_step
	var from: float = p_from
	var to: float = p_to
	for _round: int in 3:
		var hz: float = from
		while hz <= to:
			var power: float = power_at(p_samples, hz, p_rate)
			if power > most:
				most = power
				best = hz
			hz += step
		from = best - step
		to = best + step
		step /= 5.0
	return best


## Every n-th sample of what has been smoothed over n: enough for low lines.
static func thinned(p_samples: PackedFloat32Array, p_by: int) -> PackedFloat32Array:
	var out: PackedFloat32Array = []
	for index: int in range(0, p_samples.size() - p_by + 1, p_by):
		var sum: float = 0.0
		for part: int in p_by:
			sum += p_samples[index + part]
		out.append(sum / p_by)
	return out


## Level above a frequency, dB: what two first-order high-passes leave.
static func level_above_db(p_samples: PackedFloat32Array, p_hz: float, p_rate: float) -> float:
	var share: float = 1.0 - exp(-TAU * p_hz / p_rate)
	var first: float = 0.0
	var second: float = 0.0
	var sum: float = 0.0
	for value: float in p_samples:
		first += (value - first) * share
		var high: float = value - first
		second += (high - second) * share
		sum += (high - second) * (high - second)
	return 10.0 * log(maxf(sum / p_samples.size(), 1e-14)) / log(10.0)


## Greatest step between two neighbours.
static func largest_step(p_samples: PackedFloat32Array) -> float:
	var most: float = 0.0
	for index: int in range(1, p_samples.size()):
		most = maxf(most, absf(p_samples[index] - p_samples[index - 1]))
	return most
