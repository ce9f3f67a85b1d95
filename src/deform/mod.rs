//! How the model deforms with time or temperature: deformation tables and growth laws.
