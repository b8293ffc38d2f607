class_name StreamSample
extends RefCounted
## One pose of one person as a [StreamReader] has read it.

## Which of the sender's people it is: a number or a name that lasts.
var person: String = ""
## The person's name, or an empty text where the stream has none.
var name: String = ""
## The pose; its time is set by who takes it.
var pose: PoseSample = null
## When it was measured by the sender's own clock, µs; -1 where the stream does not say.
var source_usec: int = -1
## The sender's count of its samples; -1 where it has none. Two datagrams of one count are one.
var counter: int = -1
## Height of the person's hips, m; 0 where the stream does not say.
var hip_height: float = 0.0
## When it arrived, µs of Unix time, where that was before what the reader reads now; else 0.
var arrival_usec: int = 0
