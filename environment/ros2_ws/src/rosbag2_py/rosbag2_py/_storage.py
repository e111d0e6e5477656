"""The options under the name of upstream's extension module, which older tutorials use."""

from rosbag2_py.metadata import MetadataIo  # noqa: F401
from rosbag2_py.options import (  # noqa: F401
    BagMetadata,
    ConverterOptions,
    FileInformation,
    ReadOrder,
    ReadOrderSortBy,
    StorageFilter,
    StorageOptions,
    TopicInformation,
    TopicMetadata,
)
