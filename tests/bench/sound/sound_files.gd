extends RefCounted
## Figures of the synthesised sounds as they are in their files.

const Figures: GDScript = preload("sound_figures.gd")
## Crest of blasts, dB: least and most (Maher 2006, 2007); of cracks at least.
const _BLAST_CREST: Vector2 = Vector2(18.0, 22.0)
const _CRACK_CREST: float = 30.0
## When 90 % of an impact's energy is past, ms, and by how much takes may differ from it.
const _DECAYS: Dictionary[String, float] = {
	"metal": 138.0,
	"wood": 19.0,
	"concrete": 10.0,
	"sand": 11.0,
}
const _DECAY_SHARE: float = 0.5
const _LINE_SHARE: float = 0.01


## Measures all.
static func measure(p_report: BenchReport) -> void:
	_measure_blasts(p_report)
	for material: String in _DECAYS:
		_measure_impact(p_report, material)
	for rpm: int in [700, 1200, 1800, 2600]:
		_measure_line(p_report, "engine12_%d_loop" % rpm, rpm / 10.0)
		_measure_line(p_report, "engine6_%d_loop" % rpm, rpm / 20.0)
	_measure_seams(p_report)


static func _measure_blasts(p_report: BenchReport) -> void:
	for name: String in ["machine_gun_near", "cannon_near", "explosion_near", "bullet_crack"]:
		var least: float = INF
		var most: float = -INF
		for take: AudioStream in SoundBank.find(name).takes:
			var crest: float = Figures.crest_db(Figures.samples_of(take as AudioStreamWAV))
			least = minf(least, crest)
			most = maxf(most, crest)
		var is_crack: bool = name == "bullet_crack"
		var goal: float = _CRACK_CREST if is_crack else _BLAST_CREST.x
		p_report.at_least(name, "crest, least of its takes", least, "dB", goal)
		if not is_crack:
			p_report.at_most(name, "crest, most", most, "dB", _BLAST_CREST.y)


static func _measure_impact(p_report: BenchReport, p_material: String) -> void:
	var least: float = INF
	var most: float = 0.0
	for take: AudioStream in SoundBank.find("impact_" + p_material).takes:
		var stream: AudioStreamWAV = take as AudioStreamWAV
		var time: float = (
			1000.0 * Figures.energy_time(Figures.samples_of(stream), 0.9, stream.mix_rate)
		)
		least = minf(least, time)
		most = maxf(most, time)
	var middle: float = _DECAYS[p_material]
	var case: String = "impact_" + p_material
	p_report.at_least(case, "90 % of the energy, least", least, "ms", middle * (1.0 - _DECAY_SHARE))
	p_report.at_most(case, "90 % of the energy, most", most, "ms", middle * (1.0 + _DECAY_SHARE))


static func _measure_line(p_report: BenchReport, p_name: String, p_hz: float) -> void:
	var stream: AudioStreamWAV = SoundBank.find(p_name).takes[0] as AudioStreamWAV
	var thin: PackedFloat32Array = Figures.thinned(Figures.samples_of(stream), 12)
	var hz: float = Figures.strongest_hz(thin, 25.0, 400.0, 0.5, stream.mix_rate / 12.0)
	p_report.within(
		p_name,
		"strongest line beside %d Hz" % roundi(p_hz),
		100.0 * (hz / p_hz - 1.0),
		"%",
		100.0 * _LINE_SHARE
	)


static func _measure_seams(p_report: BenchReport) -> void:
	var worst: float = 0.0
	var name: String = ""
	var count: int = 0
	for file: String in DirAccess.get_files_at(SoundBank.FOLDER):
		if not file.ends_with("_loop.wav.import"):
			continue
		count += 1
		var loop: String = file.trim_suffix(".wav.import")
		var samples: PackedFloat32Array = Figures.samples_of(
			SoundBank.find(loop).takes[0] as AudioStreamWAV
		)
		var seam: float = absf(samples[0] - samples[samples.size() - 1])
		var share: float = seam / maxf(Figures.largest_step(samples), 1e-6)
		if share > worst:
			worst = share
			name = loop
	p_report.at_most(
		"%d loops" % count, "seam beside the largest step, worst (%s)" % name, worst, "", 1.0
	)
