class_name ClipCutter
extends RefCounted
## Cuts what was recorded into clips, by what was done in each frame and not by what was asked for:
## one who was to go left and went ahead has gone ahead.

## Shortest and longest clip, s; of still ones, the shortest.
const MIN_S: float = 1.0
const MAX_S: float = 4.0
const MIN_STILL_S: float = 0.6
## Maximum of a kind, s: more of the same only makes searches longer.
const KIND_S: float = 10.0
## What is cut before and after a start or a stop, s.
const BEFORE_S: float = 0.5
const AFTER_S: float = 1.5
## Speeds of a kind, heights of the hips a second.
const BAND: float = 0.4

const _DIRECTIONS: PackedStringArray = [
	"ahead",
	"ahead to the left",
	"left",
	"back to the left",
	"back",
	"back to the right",
	"right",
	"ahead to the right",
]


## A piece of a track.
class Piece:
	extends RefCounted

	var track: MotionTrack = null
	var first: int = 0
	var end: int = 0
	var stance: int = 0
	## What is done in it, in words.
	var name: String = ""
	## Pieces of a kind are much the same.
	var kind: String = ""


## The lines of a table of all that is worth keeping of some tracks.
static func cut(p_tracks: Array[MotionTrack]) -> Array[MotionSetTable.Row]:
	var pieces: Array[Piece] = []
	for track: MotionTrack in p_tracks:
		pieces.append_array(_cut_runs(track))
		if track.phase.want == GuidedPhase.Want.STARTS:
			pieces.append_array(_cut_starts(track))
	# The longest ones first, in the order in which they were made where they are as long.
	var order: Array = range(pieces.size())
	order.sort_custom(
		func(a: int, b: int) -> bool:
			var longer: int = pieces[a].end - pieces[a].first - pieces[b].end + pieces[b].first
			return longer > 0 or (longer == 0 and a < b)
	)
	var sums: Dictionary[String, float] = {}
	var kept: Array[int] = []
	for at: int in order:
		var seconds: float = (pieces[at].end - pieces[at].first) / MotionTrack.RATE
		if sums.get(pieces[at].kind, 0.0) + seconds <= KIND_S:
			sums[pieces[at].kind] = sums.get(pieces[at].kind, 0.0) + seconds
			kept.append(at)
	kept.sort()
	var rows: Array[MotionSetTable.Row] = []
	for at: int in kept:
		rows.append(_row(pieces[at]))
	return rows


static func _row(p_piece: Piece) -> MotionSetTable.Row:
	var row: MotionSetTable.Row = MotionSetTable.Row.new()
	row.file = p_piece.track.name + ".bvh"
	row.stance = p_piece.stance as MotionMatcher.Stance
	row.from_s = p_piece.first / MotionTrack.RATE
	row.to_s = p_piece.end / MotionTrack.RATE
	row.name = p_piece.name
	return row


## Stretches in which the same is done.
static func _cut_runs(p_track: MotionTrack) -> Array[Piece]:
	var pieces: Array[Piece] = []
	var first: int = 0
	for frame: int in range(1, p_track.labelled() + 1):
		if frame < p_track.labelled() and _doing(p_track, frame) == _doing(p_track, first):
			continue
		var least: float = MIN_STILL_S if p_track.is_still(first) else MIN_S
		var doing: int = _doing(p_track, first)
		if doing >= 0 and frame - first >= least * MotionTrack.RATE:
			pieces.append_array(_split(p_track, first, frame))
		first = frame
	return pieces


## What is done in a frame, as a number; negative: nothing that a clip is made of.
static func _doing(p_track: MotionTrack, p_frame: int) -> int:
	var stance: int = p_track.stances[p_frame] * 64
	if stance >= MotionMatcher.PRONE * 64:
		# Who lies faces nowhere: his poses are made.
		return -1
	if p_track.goes(p_frame):
		var turn: float = p_track.turns[p_frame]
		var bend: int = 0 if absf(turn) < MotionTrack.CURVE_TURN.x else 1 if turn > 0.0 else 2
		return stance + 8 * bend + p_track.sector(p_frame)
	if p_track.is_still(p_frame):
		return stance + 32
	if p_track.turns_on_spot(p_frame):
		return stance + (33 if p_track.turns[p_frame] > 0.0 else 34)
	return -1


static func _split(p_track: MotionTrack, p_first: int, p_end: int) -> Array[Piece]:
	var count: int = ceili((p_end - p_first) / (MAX_S * MotionTrack.RATE))
	var pieces: Array[Piece] = []
	for part: int in count:
		var piece: Piece = Piece.new()
		piece.track = p_track
		piece.first = p_first + (p_end - p_first) * part / count
		piece.end = p_first + (p_end - p_first) * (part + 1) / count
		_name(piece)
		pieces.append(piece)
	return pieces


static func _name(r_piece: Piece) -> void:
	var track: MotionTrack = r_piece.track
	var speed: float = 0.0
	for frame: int in range(r_piece.first, r_piece.end):
		speed += track.speeds[frame] / (r_piece.end - r_piece.first)
	var doing: int = _doing(track, r_piece.first)
	r_piece.stance = track.stances[r_piece.first]
	r_piece.kind = "%d %d" % [doing, roundi(speed / BAND)]
	var what: String = ""
	match doing % 64:
		32:
			what = "stand"
		33:
			what = "turn left"
		34:
			what = "turn right"
		_:
			what = _DIRECTIONS[doing % 8] + ["", ", left curve", ", right curve"][doing % 64 / 8]
			what += " %.1f" % (speed * track.hip_height)
	r_piece.name = ("crouched " if r_piece.stance == MotionMatcher.CROUCH else "") + what


## Where somebody starts or stops: from standing to going and the other way round.
static func _cut_starts(p_track: MotionTrack) -> Array[Piece]:
	var pieces: Array[Piece] = []
	var went: int = -1
	for frame: int in p_track.labelled():
		var now: int = 1 if p_track.goes(frame) else 0 if p_track.is_still(frame) else went
		if went >= 0 and now != went:
			var piece: Piece = Piece.new()
			piece.track = p_track
			var before: float = BEFORE_S if now == 1 else AFTER_S
			var after: float = AFTER_S if now == 1 else BEFORE_S
			piece.first = maxi(frame - roundi(before * MotionTrack.RATE), 0)
			piece.end = mini(frame + roundi(after * MotionTrack.RATE), p_track.labelled())
			piece.stance = p_track.stances[frame]
			piece.name = "start" if now == 1 else "stop"
			piece.kind = piece.name
			pieces.append(piece)
		went = now
	return pieces
