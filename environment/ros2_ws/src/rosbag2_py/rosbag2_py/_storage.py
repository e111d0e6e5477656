"""The options under the name of upstream's extension module, which older tutorials use."""

from rosbag2_py.options import (  # noqa: F401
    BagMetadata,
    ConverterOptions,
    StorageFilter,
    StorageOptions,
    TopicInformation,
    TopicMetadata,
)
