"""Files of gases of discs: snapshots as GSD, extended XYZ and Parquet, and streams of events as Parquet.

Each writer appends frame after frame while a run goes on. Between frames nothing is open: what stands in a file is
whole, and a frame that cannot be written leaves the earlier ones as they were.
"""

from carom.records.cutting import cut_events, cut_frames
from carom.records.event_files import EventWriter, events_to_parquet
from carom.records.gsd import GsdWriter
from carom.records.parquet import ParquetWriter
from carom.records.reading import content_hash, frame_count, frames, read_snapshot, recover
from carom.records.snapshot import Snapshot
from carom.records.xyz import ExtendedXyzWriter

__all__ = [
    "EventWriter",
    "ExtendedXyzWriter",
    "GsdWriter",
    "ParquetWriter",
    "Snapshot",
    "content_hash",
    "cut_events",
    "cut_frames",
    "events_to_parquet",
    "frame_count",
    "frames",
    "read_snapshot",
    "recover",
]
